// SPDX-License-Identifier: Apache-2.0
#include "render/sensor.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "render/random.hpp"

namespace trihedron::render {
namespace {

constexpr double kMidGrey = 100;  // the level that a change of contrast leaves alone

cv::Mat white_noise(cv::Size size, double sigma, std::uint64_t seed) {
  cv::Mat noise(size, CV_32F);
  for (int y = 0; y < size.height; ++y) {
    Random random(seed, static_cast<std::uint64_t>(y));
    for (int x = 0; x < size.width; ++x)
      noise.at<float>(y, x) = static_cast<float>(sigma * random.normal());
  }
  return noise;
}

cv::Mat blurred(const cv::Mat& image, double sigma) {
  cv::Mat out;
  cv::GaussianBlur(image, out, {0, 0}, sigma, sigma, cv::BORDER_REPLICATE);
  return out;
}

// White noise of standard deviation 1, blurred by a Gaussian of sigma s px, keeps 1 / (2 sqrt(pi)
// s).
cv::Mat grain(cv::Size size, const Sensor& sensor, std::uint64_t seed) {
  const double gain = 2 * std::sqrt(3.141592653589793) * sensor.grain_size_px;
  return blurred(white_noise(size, sensor.grain * gain, seed), sensor.grain_size_px);
}

void vignette(cv::Mat& image, double loss) {
  const double cx = (image.cols - 1) / 2.0, cy = (image.rows - 1) / 2.0;
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const double r2 = ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (cx * cx + cy * cy);
      image.at<float>(y, x) *= static_cast<float>(1 - loss * r2);
    }
}

}  // namespace

cv::Mat expose(const cv::Mat& ideal, const Sensor& sensor, std::uint64_t seed) {
  cv::Mat image = sensor.contrast * ideal + (1 - sensor.contrast) * kMidGrey;
  if (sensor.vignetting > 0) vignette(image, sensor.vignetting);
  if (sensor.grain > 0) image += grain(image.size(), sensor, mix(seed));
  if (sensor.blur_px > 0) image = blurred(image, sensor.blur_px);
  if (sensor.noise > 0) image += white_noise(image.size(), sensor.noise, seed);
  cv::Mat grey;
  image.convertTo(grey, CV_8U);
  return grey;
}

}  // namespace trihedron::render
