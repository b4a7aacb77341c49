// SPDX-License-Identifier: Apache-2.0
#include "golden/front_end.hpp"

#include <string>

#include "golden/error.hpp"

namespace trihedron::golden {

ViewFeatures run_front_end(const std::uint8_t* grey, int width, int height, int stride,
                           const FrontEndConfig& config) {
  if (width < kMinFrameSide || height < kMinFrameSide) {
    throw Error("image is " + std::to_string(width) + " x " + std::to_string(height) +
                " px, the front end needs at least " + std::to_string(kMinFrameSide) + " x " +
                std::to_string(kMinFrameSide));
  }
  const GradientImage image = gradient(grey, width, height, stride);
  const Plane<std::uint8_t> first = first_contour(image.magnitude, config.first_contour);
  const Plane<std::uint8_t> second =
      second_contour(image, first, config.first_contour.noise_floor, config.second_contour);

  ViewFeatures features;
  features.width = width;
  features.height = height;
  features.contour.resize(first.samples.size());
  for (std::size_t i = 0; i < features.contour.size(); ++i) {
    ContourBeat& beat = features.contour[i];
    beat.gx = image.gx.samples[i];
    beat.gy = image.gy.samples[i];
    beat.magnitude = image.magnitude.samples[i];
    beat.flags = static_cast<std::uint8_t>((second.samples[i] ? kContour : 0) |
                                           (first.samples[i] ? kFirstContour : 0));
  }
  features.vertices = vertices(image, second, config.vertices);
  return features;
}

}  // namespace trihedron::golden
