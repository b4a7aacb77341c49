// SPDX-License-Identifier: Apache-2.0
#include "golden/second_contour.hpp"

#include <cstdlib>

namespace trihedron::golden {
namespace {

/// The neighbour across the contour: the step along the gradient, to one of eight neighbours.
struct Step {
  int x;
  int y;
};

Step step_along(int gx, int gy) {
  const int ax = std::abs(gx);
  const int ay = std::abs(gy);
  const bool horizontal = 2 * ay < ax;
  const bool vertical = 2 * ax < ay;
  return {vertical ? 0 : 1, horizontal ? 0 : vertical ? 1 : ((gx < 0) == (gy < 0) ? 1 : -1)};
}

}  // namespace

Plane<std::uint8_t> second_contour(const GradientImage& gradient,
                                   const Plane<std::uint8_t>& first_contour,
                                   const SecondContourConfig& config) {
  const Plane<std::uint16_t>& magnitude = gradient.magnitude;
  Plane<std::uint8_t> contour(magnitude.width, magnitude.height);
  for (int y = kWindowRadius; y < magnitude.height - kWindowRadius; ++y) {
    for (int x = kWindowRadius; x < magnitude.width - kWindowRadius; ++x) {
      if (first_contour.at(x, y) == 0) continue;
      int sum = 0;
      for (int j = -kWindowRadius; j <= kWindowRadius; ++j) {
        for (int i = -kWindowRadius; i <= kWindowRadius; ++i) {
          sum += first_contour.at(x + i, y + j) ? magnitude.at(x + i, y + j) : 0;
        }
      }
      const Step s = step_along(gradient.gx.at(x, y), gradient.gy.at(x, y));
      const int centre = magnitude.at(x, y);
      contour.at(x, y) = sum >= config.support && centre > magnitude.at(x - s.x, y - s.y) &&
                         centre >= magnitude.at(x + s.x, y + s.y);
    }
  }
  return contour;
}

}  // namespace trihedron::golden
