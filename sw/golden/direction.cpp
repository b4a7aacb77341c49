// SPDX-License-Identifier: Apache-2.0
#include "golden/direction.hpp"

#include <algorithm>
#include <cstdlib>

#include "golden/set_pixels.hpp"

namespace trihedron::golden {

int direction_sector(int gx, int gy) {
  // Quadrants start on the axes x, y, -x, -y and each holds its own axis; opposite ones are one.
  const bool odd = gy > 0 ? gx <= 0 : gy < 0 && gx >= 0;
  const int along = std::abs(odd ? gy : gx);
  const int beyond = std::abs(odd ? gx : gy);
  const int minor = std::min(along, beyond);
  const int major = std::max(along, beyond);
  int step = 0;
  for (const int threshold : {6, 13, 19, 27, 34, 43, 53}) {
    step += 64 * minor >= threshold * major ? 1 : 0;
  }
  return 16 * (odd ? 1 : 0) + (along >= beyond ? step : 15 - step);
}

int magnitude_class(int magnitude, int floor) {
  return (magnitude >= floor) + (2 * magnitude >= 3 * floor) + (2 * magnitude >= 5 * floor);
}

void direction_row(const GradientImage& gradient, const Plane<std::uint8_t>& second_contour,
                   int floor, int y, Plane<Direction>& out) {
  clear_row(out, y);
  const std::int16_t* gx = gradient.gx.row(y);
  const std::int16_t* gy = gradient.gy.row(y);
  const std::uint16_t* magnitude = gradient.magnitude.row(y);
  Direction* direction = out.row(y);
  for_each_set(second_contour.row(y), 0, out.width, [&](int x) {
    const int strength = magnitude_class(magnitude[x], floor);
    if (strength == 0) return;
    direction[x] =
        static_cast<Direction>(strength << kDirectionBits | direction_sector(gx[x], gy[x]));
  });
}

Plane<Direction> directions(const GradientImage& gradient,
                            const Plane<std::uint8_t>& second_contour, int floor) {
  Plane<Direction> out(second_contour.width, second_contour.height);
  for (int y = 0; y < out.height; ++y) direction_row(gradient, second_contour, floor, y, out);
  return out;
}

}  // namespace trihedron::golden
