// SPDX-License-Identifier: Apache-2.0
#include "golden/gradient.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace trihedron::golden {
namespace {

/// Fraction bits of the sums |H| + |V| + 4|D| + 4|E| and H + 8 (D - E) below 1/kGradientScale.
constexpr int kShift = 10 - kGradientFractionBits;
constexpr int kHalf = 1 << (kShift - 1);
static_assert(kGradientFractionBits >= 0 && kShift >= 1, "0 to 9 fraction bits");

/// Nearest integer to sum / 2^kShift, halves away from zero: mirrored images have mirrored slopes.
inline int round_shift(int sum) { return (sum + kHalf - (sum < 0 ? 1 : 0)) >> kShift; }

/// The five rows of the window, centre row in the middle.
using WindowRows = std::array<const std::uint8_t*, kMinFrameSide>;

/// Mask D at column x; `s` = 1 looks down right, `s` = -1 mirrors it (mask E).
template <int s>
inline int diagonal(const WindowRows& rows, int x) {
  const auto [a, b, c, d, e] = rows;
  return (e[x + 2 * s] - a[x - 2 * s]) + 4 * (d[x + s] - b[x - s]) +
         2 * (d[x + 2 * s] + e[x + s] - a[x - s] - b[x - 2 * s]) +
         5 * (c[x + s] + d[x] - b[x] - c[x - s]) + 3 * (c[x + 2 * s] + e[x] - a[x] - c[x - 2 * s]) +
         (b[x + 2 * s] + e[x - s] - a[x + s] - d[x - 2 * s]);
}

void gradient_row(const WindowRows& rows, int width, std::int16_t* gx, std::int16_t* gy,
                  std::uint16_t* magnitude) {
  const auto [a, b, c, d, e] = rows;
  const auto smooth = [&](int x) { return a[x] + 4 * (b[x] + d[x]) + 6 * c[x] + e[x]; };
  const auto slope = [&](int x) { return e[x] - a[x] + 6 * (d[x] - b[x]); };
  for (int x = kWindowRadius; x < width - kWindowRadius; ++x) {
    const int h = smooth(x + 2) - smooth(x - 2) + 6 * (smooth(x + 1) - smooth(x - 1));
    const int v = slope(x - 2) + slope(x + 2) + 4 * (slope(x - 1) + slope(x + 1)) + 6 * slope(x);
    const int down_right = diagonal<1>(rows, x);
    const int down_left = diagonal<-1>(rows, x);
    gx[x] = static_cast<std::int16_t>(round_shift(h + 8 * (down_right - down_left)));
    gy[x] = static_cast<std::int16_t>(round_shift(v + 8 * (down_right + down_left)));
    const int sum = std::abs(h) + std::abs(v) + 4 * (std::abs(down_right) + std::abs(down_left));
    magnitude[x] = static_cast<std::uint16_t>(std::min((sum + kHalf) >> kShift, kMaxMagnitude));
  }
}

}  // namespace

GradientImage gradient(const std::uint8_t* grey, int width, int height, int stride) {
  GradientImage image{Plane<std::int16_t>(width, height), Plane<std::int16_t>(width, height),
                      Plane<std::uint16_t>(width, height)};
  for (int y = kWindowRadius; y < height - kWindowRadius; ++y) {
    WindowRows rows;
    for (int i = 0; i < kMinFrameSide; ++i) {
      rows[i] = grey + static_cast<std::ptrdiff_t>(y - kWindowRadius + i) * stride;
    }
    gradient_row(rows, width, image.gx.row(y), image.gy.row(y), image.magnitude.row(y));
  }
  return image;
}

}  // namespace trihedron::golden
