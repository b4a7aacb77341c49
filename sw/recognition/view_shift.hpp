// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/refinement.hpp"

namespace trihedron {

/// Largest error of a camera's calibration that is made up for, px in the image.
inline constexpr double kMostShiftPx = 3;

/// By how much a view shows an object beside its predicted place, px: cameras that disagree about a
/// pose show it shifted, one this way, the other that way. Robust least squares of the contours
/// nearest to the predicted edges; 0 where they leave it open.
Eigen::Vector2d view_shift(const ContourField& field, const std::vector<EdgePoint>& points);

}  // namespace trihedron
