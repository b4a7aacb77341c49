// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recognition/surfaces.hpp"

namespace trihedron {

/// Which of the surfaces the corners of the other views contradict. That happens when a region is
/// two faces between which no contour was seen, and some other view sees the corner between them:
///
/// - a corner of a top surface stands more than 2 Errors in front of a side or front surface and
///   projects into its region or onto its boundary, yet the region has no corner there;
/// - the same of a top corner whose height is unknown because it has no partner in that view;
/// - a side or front corner that has no partner in the top view lies on an edge of a top surface.
///
/// `surfaces` complete ones; `corners` of all regions, by role, world mm. One flag a surface.
std::vector<bool> contradicted_surfaces(const std::vector<CrossedSurface>& surfaces,
                                        const MeasuredCorners& corners, double error_mm);

}  // namespace trihedron
