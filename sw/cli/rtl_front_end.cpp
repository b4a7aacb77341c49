// SPDX-License-Identifier: Apache-2.0
#include "cli/rtl_front_end.hpp"

#include "cli/frame_inputs.hpp"
#include "sim/simulator.hpp"

namespace trihedron::cli {
namespace {

report::ViewActivity activity_of(const sim::ViewStatistics& view) {
  return {view.pixels,        view.input_stalls,   view.input_idles,
          view.contour_beats, view.contour_stalls, view.latency_clocks,
          view.vertices,      view.vertices_lost,  view.stream_errors};
}

}  // namespace

FrontEnd rtl_front_end(report::HardwareActivity* activity) {
  return [activity](const std::vector<cv::Mat>& images) {
    std::vector<sim::GreyImage> views;
    for (const cv::Mat& image : images) views.push_back(to_grey_image(image));
    sim::Report report;
    std::vector<ViewFeatures> features = sim::simulate_views(views, {}, &report);
    if (activity == nullptr) return features;
    *activity = {report.clocks, {}};
    for (std::size_t v = 0; v < views.size(); ++v)
      activity->views.push_back(activity_of(report.views[v]));
    return features;
  };
}

std::string default_front_end() { return "rtl"; }

}  // namespace trihedron::cli
