// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

/// Adds to `contour` (1, raster order) the edges below the hardware's threshold that stand out of
/// this view's own noise: runs of at least 10 connected pixels where the magnitude is largest
/// across its gradient and above three times its median beside the contours.
void add_weak_ridges(const ViewFeatures& features, std::vector<std::uint8_t>* contour);

/// The median magnitude of the pixels that are no first contour: what noise alone gives.
int noise_magnitude(const ViewFeatures& features);

}  // namespace trihedron
