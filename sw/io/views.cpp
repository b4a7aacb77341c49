// SPDX-License-Identifier: Apache-2.0
#include "io/views.hpp"

#include <utility>

namespace trihedron {

FrontEnd golden_front_end(const golden::FrontEndConfig& config) {
  return [config](const std::vector<cv::Mat>& images) {
    std::vector<ViewFeatures> out;
    for (const cv::Mat& image : images)
      out.push_back(golden::run_front_end(image.data, image.cols, image.rows,
                                          static_cast<int>(image.step), config));
    return out;
  };
}

std::vector<View> make_views(const Scene& scene, const FrontEnd& front_end) {
  std::vector<ViewFeatures> features = front_end(scene.images);
  std::vector<View> views;
  for (std::size_t v = 0; v < scene.cameras.size(); ++v)
    views.push_back({scene.cameras[v], std::move(features[v])});
  return views;
}

}  // namespace trihedron
