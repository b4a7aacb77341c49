// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace trihedron::render {

/// What lens and sensor do to an ideal image, in this order.
struct Sensor {
  double contrast = 1;         ///< grey-level differences are multiplied by this
  double vignetting = 0;       ///< loss of light in the image's corners, fraction
  double grain = 0;            ///< standard deviation of a blotchy noise, grey levels
  double grain_size_px = 1.5;  ///< standard deviation of one blotch
  double blur_px = 0;          ///< standard deviation of the point spread function
  double noise = 0;            ///< standard deviation of the pixel noise, grey levels
};

/// The 8-bit picture of `ideal` (CV_32F, grey levels). Same seed, same picture.
cv::Mat expose(const cv::Mat& ideal, const Sensor& sensor, std::uint64_t seed);

}  // namespace trihedron::render
