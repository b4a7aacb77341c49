// SPDX-License-Identifier: Apache-2.0
// The golden front end, stage by stage and whole, beside OpenCV's Canny and corner detector on
// the same images, one thread.
#include <benchmark/benchmark.h>

#include <opencv2/imgproc.hpp>
#include <utility>

#include "bench/ratios.hpp"
#include "bench/scenes.hpp"
#include "golden/front_end.hpp"

namespace trihedron::bench {
namespace {

using golden::FrontEndConfig;
using golden::GradientImage;
using golden::Plane;

GradientImage gradient_of(const cv::Mat& image) {
  return golden::gradient(image.data, image.cols, image.rows, static_cast<int>(image.step));
}

/// An image and what each stage gets of it.
struct Input {
  std::string size;
  cv::Mat image;
  GradientImage gradient = gradient_of(image);
  Plane<std::uint8_t> first = golden::first_contour(gradient.magnitude, {});
  Plane<std::uint8_t> second =
      golden::second_contour(gradient, first, FrontEndConfig{}.first_contour.noise_floor, {});
};

/// Contours as users of OpenCV get them; thresholds low enough for the weak edges of laboratory
/// scenes.
cv::Mat opencv_contour(const cv::Mat& image) {
  cv::Mat smooth, contour;
  cv::GaussianBlur(image, smooth, {}, 1.0);
  cv::Canny(smooth, contour, 20, 50);
  return contour;
}

/// Corners as users of OpenCV get them: Shi and Tomasi's, at most 1000, 3 px apart.
std::vector<cv::Point2f> opencv_corners(const cv::Mat& image) {
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(image, corners, 1000, 0.01, 3);
  return corners;
}

template <typename Work>
void add(const std::string& name, const Input& input, Work work) {
  benchmark::RegisterBenchmark((name + " " + input.size).c_str(), [&input,
                                                                   work](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(work(input));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(input.image.total()));
  })->Unit(benchmark::kMicrosecond);
}

void add_stages(const Input& input) {
  add("gradient", input, [](const Input& in) { return gradient_of(in.image); });
  add("first_contour", input,
      [](const Input& in) { return golden::first_contour(in.gradient.magnitude, {}); });
  add("second_contour", input, [](const Input& in) {
    return golden::second_contour(in.gradient, in.first, FrontEndConfig{}.first_contour.noise_floor,
                                  {});
  });
  add("vertices", input,
      [](const Input& in) { return golden::vertices(in.gradient, in.second, {}); });
  add("front_end", input, [](const Input& in) {
    return golden::run_front_end(in.image.data, in.image.cols, in.image.rows,
                                 static_cast<int>(in.image.step));
  });
}

void add_peers(const Input& input) {
  add("cv::Canny", input, [](const Input& in) { return opencv_contour(in.image); });
  add("cv::goodFeaturesToTrack", input, [](const Input& in) { return opencv_corners(in.image); });
  add("opencv", input, [](const Input& in) {
    return std::make_pair(opencv_contour(in.image), opencv_corners(in.image));
  });
}

}  // namespace
}  // namespace trihedron::bench

int main(int argc, char** argv) {
  using namespace trihedron::bench;
  cv::setNumThreads(1);
  const std::vector<Input> inputs = {{"450x300", scene_of_kind("lab-two").images[0]},
                                     {"1280x960", scene_of_kind("lab-hd").images[0]}};
  std::vector<Ratio> ratios;
  for (const Input& input : inputs) {
    add_stages(input);
    add_peers(input);
    ratios.push_back({"OpenCV / golden front end, " + input.size, "opencv " + input.size,
                      "front_end " + input.size});
  }
  return run_and_compare(argc, argv, ratios, 9);
}
