// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/hypotheses.hpp"
#include "recognition/index.hpp"
#include "recognition/pose_pool.hpp"

namespace trihedron {

/// Adds the poses that map two edges of a model onto two whole edges in space that need not
/// touch: lengths and the distances of their ends must agree. It finds objects whose corners no
/// two views share, such as a prism under another object. Pairs whose segments are all claimed
/// (per view and segment) are left out.
void poses_from_edge_pairs(const std::vector<ViewLines>& views, const std::vector<SpaceEdge>& edges,
                           const std::vector<Model>& library, const LibraryIndex& index,
                           const HypothesisOptions& options, const Claims& claimed, PosePool& pool);

}  // namespace trihedron
