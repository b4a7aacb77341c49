// SPDX-License-Identifier: Apache-2.0
#include "golden/first_contour.hpp"

#include <algorithm>

namespace trihedron::golden {

Plane<std::uint8_t> first_contour(const GradientImage& gradient, const FirstContourConfig& config) {
  const Plane<std::uint16_t>& magnitude = gradient.magnitude;
  Plane<std::uint8_t> contour(magnitude.width, magnitude.height);
  for (int y = kWindowRadius; y < magnitude.height - kWindowRadius; ++y) {
    for (int x = kWindowRadius; x < magnitude.width - kWindowRadius; ++x) {
      const int centre = magnitude.at(x, y);
      int weight = 0;
      for (int j = -kWindowRadius; j <= kWindowRadius; ++j) {
        for (int i = -kWindowRadius; i <= kWindowRadius; ++i) {
          weight += std::max(0, centre - magnitude.at(x + i, y + j));
        }
      }
      contour.at(x, y) =
          centre >= config.noise_floor && 8 * weight >= config.relative_weight * centre;
    }
  }
  return contour;
}

}  // namespace trihedron::golden
