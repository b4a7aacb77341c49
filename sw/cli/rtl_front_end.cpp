// SPDX-License-Identifier: Apache-2.0
#include "cli/rtl_front_end.hpp"

#include "cli/frame_inputs.hpp"
#include "sim/simulator.hpp"

namespace trihedron::cli {

FrontEnd rtl_front_end() {
  return [](const std::vector<cv::Mat>& images) {
    std::vector<sim::GreyImage> views;
    for (const cv::Mat& image : images) views.push_back(to_grey_image(image));
    return sim::simulate_views(views);
  };
}

std::string default_front_end() { return "rtl"; }

}  // namespace trihedron::cli
