// SPDX-License-Identifier: Apache-2.0
#include "report/picture_layers.hpp"

#include <cmath>

namespace trihedron::report {

cv::Mat gradient_picture(const ViewFeatures& features) {
  constexpr double kWhite = 24.0 * kGradientScale;
  constexpr int kStepMask = 0xf8;
  cv::Mat picture(features.height, features.width, CV_8U);
  for (int y = 0; y < features.height; ++y)
    for (int x = 0; x < features.width; ++x) {
      const int tone =
          cv::saturate_cast<unsigned char>(255 * std::sqrt(features.at(x, y).magnitude / kWhite));
      picture.at<unsigned char>(y, x) =
          static_cast<unsigned char>((tone & kStepMask) | (tone >> 5));  // 31 steps reach 255
    }
  return picture;
}

cv::Mat contour_picture(const ViewFeatures& features, ContourFlag flag, const cv::Vec3b& colour) {
  cv::Mat picture(features.height, features.width, CV_8UC4, cv::Scalar());
  for (int y = 0; y < features.height; ++y)
    for (int x = 0; x < features.width; ++x)
      if ((features.at(x, y).flags & flag) != 0)
        picture.at<cv::Vec4b>(y, x) = {colour[0], colour[1], colour[2], 255};
  return picture;
}

}  // namespace trihedron::report
