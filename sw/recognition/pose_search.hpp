// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/hypotheses.hpp"
#include "recognition/recognize.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

/// What method full knows before it looks closely: edge points and lines per view, edges in space,
/// poses.
struct PoseSearch {
  std::vector<EdgelMap> edgels;  ///< per view
  std::vector<ViewLines> lines;  ///< per view
  std::vector<SpaceEdge> edges;
  std::vector<PoseHypothesis> hypotheses;  ///< likeliest first
  std::vector<StageStatistics> stages;     ///< segments, crossing, hypotheses
};

/// From the features of all views to ranked poses of the library's models. The views must have
/// passed check_views.
PoseSearch search_poses(const std::vector<View>& views, const std::vector<Model>& library,
                        const LibraryIndex& index, const HypothesisOptions& options = {});

/// Poses of objects that `known` ones hide in part, from the lines that those leave: an edge may
/// end where one view alone sees its corner.
std::vector<PoseHypothesis> search_rest(const std::vector<View>& views, const PoseSearch& search,
                                        const std::vector<PlacedModel>& known,
                                        const std::vector<Model>& library,
                                        const LibraryIndex& index,
                                        const HypothesisOptions& options = {});

}  // namespace trihedron
