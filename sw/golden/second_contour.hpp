// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Registers of stage 3.
struct SecondContourConfig {
  /// Smallest weighted sum of the window's first-contour magnitudes, 1/kGradientScale grey level
  /// per px.
  int support = 144;
};

/// Stage 3 (provisional definition). The first-contour pixels on the ridge of the magnitude
/// across the gradient direction whose window holds enough first contour.
Plane<std::uint8_t> second_contour(const GradientImage& gradient,
                                   const Plane<std::uint8_t>& first_contour,
                                   const SecondContourConfig& config);

}  // namespace trihedron::golden
