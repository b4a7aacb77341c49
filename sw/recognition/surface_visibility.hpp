// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recognition/planar_view.hpp"
#include "recognition/surfaces.hpp"

namespace trihedron {

/// Whether a corner of another surface, `corner` (world, mm), contradicts a surface made from a
/// side or front region: it stands more than 2 `error_mm` in front of the surface's plane and
/// projects into the region or onto its boundary, so the view would show it there, yet the region
/// has no corner there. That happens when a region is two faces between which no contour was
/// seen.
bool contradicts(const Eigen::Vector3d& corner, const CrossedSurface& surface, double error_mm);

}  // namespace trihedron
