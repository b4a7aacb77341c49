// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

struct ContourPixel {
  std::int16_t x, y;
};

/// The contour stream's pixels that stand above this frame's own noise, in raster order: those
/// whose smoothed gradient noise alone hardly reaches. `noise` is the standard deviation of one
/// component of the smoothed gradient (EdgelMap::noise).
std::vector<ContourPixel> clear_contour(const ViewFeatures& features, float noise);

}  // namespace trihedron
