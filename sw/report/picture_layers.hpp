// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "golden/features.hpp"

namespace trihedron::report {

/// The contour stream's gradient magnitude as an 8-bit picture. Its tone is the square root of the
/// magnitude, white from 24 grey levels per px on, in 32 steps: weak edges show, and it packs well.
cv::Mat gradient_picture(const ViewFeatures& features);

/// The pixels of the contour stream that carry `flag`, in `colour` (BGR) on nothing.
cv::Mat contour_picture(const ViewFeatures& features, ContourFlag flag, const cv::Vec3b& colour);

}  // namespace trihedron::report
