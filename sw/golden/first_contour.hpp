// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Registers of stage 2.
struct FirstContourConfig {
  /// Smallest magnitude of a contour pixel, 1/kGradientScale grey level per px; 1 .. kMaxMagnitude.
  int noise_floor = 8;
  /// Smallest weight of the centre against its window, 1/8 of the centre's magnitude; 0 .. 191.
  int relative_weight = 32;
};

/// Stage 2 (provisional definition). The pixels whose magnitude c stands out of the 24 others n
/// of their 5x5 window: c >= noise_floor and 8 sum max(0, c - n) >= relative_weight * c. A pixel
/// whose window leaves the image is none.
Plane<std::uint8_t> first_contour(const GradientImage& gradient, const FirstContourConfig& config);

}  // namespace trihedron::golden
