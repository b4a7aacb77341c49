// SPDX-License-Identifier: Apache-2.0
#include "golden/ridge.hpp"

#include <array>
#include <cstdlib>

#include "golden/set_pixels.hpp"

namespace trihedron::golden {
namespace {

/// Sum of the first-contour magnitudes of the window. Few pixels are first contour, so a sum of
/// its own for each of them is quicker than running sums for all.
int support_of(const Plane<std::uint16_t>& magnitude, const Plane<std::uint8_t>& first, int x,
               int y) {
  int sum = 0;
  for (int j = y - kWindowRadius; j <= y + kWindowRadius; ++j) {
    const std::uint16_t* m = magnitude.row(j) + x - kWindowRadius;
    const std::uint8_t* f = first.row(j) + x - kWindowRadius;
    for (int i = 0; i < kMinFrameSide; ++i) sum += m[i] * f[i];
  }
  return sum;
}

/// Whether the centre is highest across the contour; `rows` are the rows above, at and below it.
inline bool highest_across(const std::array<const std::uint16_t*, 3>& rows, int x, int gx, int gy) {
  const auto [above, at, below] = rows;
  const int centre = at[x];
  const auto highest = [centre](int before, int after) {
    return (before < centre) & (after <= centre);
  };
  const bool horizontal = 2 * std::abs(gy) < std::abs(gx);
  const bool vertical = 2 * std::abs(gx) < std::abs(gy);
  const bool falling = (gx < 0) == (gy < 0);
  return horizontal ? highest(at[x - 1], at[x + 1])
         : vertical ? highest(above[x], below[x])
         : falling  ? highest(above[x - 1], below[x + 1])
                    : highest(below[x - 1], above[x + 1]);
}

}  // namespace

void ridge_row(const GradientImage& gradient, const Plane<std::uint8_t>& first_contour,
               const SecondContourConfig& config, int y, Plane<std::uint8_t>& out) {
  if (!clear_row(out, y)) return;
  const Plane<std::uint16_t>& magnitude = gradient.magnitude;
  const std::array<const std::uint16_t*, 3> rows{magnitude.row(y - 1), magnitude.row(y),
                                                 magnitude.row(y + 1)};
  const std::int16_t* gx = gradient.gx.row(y);
  const std::int16_t* gy = gradient.gy.row(y);
  std::uint8_t* ridge_row = out.row(y);
  const auto visit = [&](int x) {
    ridge_row[x] = highest_across(rows, x, gx[x], gy[x]) &&
                   support_of(magnitude, first_contour, x, y) >= config.support;
  };
  for_each_set(first_contour.row(y), kWindowRadius, out.width - kWindowRadius, visit);
}

Plane<std::uint8_t> ridge(const GradientImage& gradient, const Plane<std::uint8_t>& first_contour,
                          const SecondContourConfig& config) {
  Plane<std::uint8_t> out(first_contour.width, first_contour.height);
  for (int y = 0; y < out.height; ++y) ridge_row(gradient, first_contour, config, y, out);
  return out;
}

}  // namespace trihedron::golden
