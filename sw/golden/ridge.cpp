// SPDX-License-Identifier: Apache-2.0
#include "golden/ridge.hpp"

#include <array>
#include <cstdlib>

namespace trihedron::golden {
namespace {

/// Per column the sum of the first-contour magnitudes of the five window rows around y.
void column_sums(const Plane<std::uint16_t>& magnitude, const Plane<std::uint8_t>& first, int y,
                 std::vector<std::uint16_t>& sums) {
  for (int x = 0; x < magnitude.width; ++x) sums[static_cast<std::size_t>(x)] = 0;
  for (int j = y - kWindowRadius; j <= y + kWindowRadius; ++j) {
    const std::uint16_t* m = magnitude.row(j);
    const std::uint8_t* f = first.row(j);
    std::uint16_t* sum = sums.data();
    for (int x = 0; x < magnitude.width; ++x) {
      sum[x] = static_cast<std::uint16_t>(sum[x] + (f[x] ? m[x] : 0));
    }
  }
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

Plane<std::uint8_t> ridge(const GradientImage& gradient, const Plane<std::uint8_t>& first_contour,
                          const SecondContourConfig& config) {
  const Plane<std::uint16_t>& magnitude = gradient.magnitude;
  Plane<std::uint8_t> out(magnitude.width, magnitude.height);
  std::vector<std::uint16_t> sums(static_cast<std::size_t>(magnitude.width));
  for (int y = kWindowRadius; y < magnitude.height - kWindowRadius; ++y) {
    column_sums(magnitude, first_contour, y, sums);
    const std::array<const std::uint16_t*, 3> rows{magnitude.row(y - 1), magnitude.row(y),
                                                   magnitude.row(y + 1)};
    const std::uint8_t* first = first_contour.row(y);
    const std::int16_t* gx = gradient.gx.row(y);
    const std::int16_t* gy = gradient.gy.row(y);
    const std::uint16_t* sum = sums.data();
    std::uint8_t* ridge_row = out.row(y);
    for (int x = kWindowRadius; x < magnitude.width - kWindowRadius; ++x) {
      if (first[x] == 0) continue;
      const int support = sum[x - 2] + sum[x - 1] + sum[x] + sum[x + 1] + sum[x + 2];
      ridge_row[x] = (support >= config.support) & highest_across(rows, x, gx[x], gy[x]);
    }
  }
  return out;
}

}  // namespace trihedron::golden
