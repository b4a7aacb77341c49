// SPDX-License-Identifier: Apache-2.0
#include "golden/gradient.hpp"

#include <algorithm>
#include <cstdlib>

namespace trihedron::golden {
namespace {

/// Fraction bits of the sums |H| + |V| + 2|D| + 2|E| and H + 4 (D - E) below 1/kGradientScale.
constexpr int kShift = 9 - kGradientFractionBits;
constexpr int kHalf = 1 << (kShift - 1);
static_assert(kShift >= 1, "the gradient keeps at most 8 fraction bits");

/// Nearest integer to sum / 2^kShift, halves away from zero: mirrored images have mirrored slopes.
inline int round_shift(int sum) { return (sum + kHalf - (sum < 0 ? 1 : 0)) >> kShift; }

/// The rows y - 2 .. y + 2 of the window's centre row y.
struct WindowRows {
  const std::uint8_t* r[5];
};

void gradient_row(const WindowRows& rows, int width, std::int16_t* gx, std::int16_t* gy,
                  std::uint16_t* magnitude) {
  const auto [a, b, c, d, e] = rows.r;
  const auto smooth = [&](int x) { return a[x] + 4 * b[x] + 6 * c[x] + 4 * d[x] + e[x]; };
  const auto slope = [&](int x) { return e[x] - a[x] + 2 * (d[x] - b[x]); };
  for (int x = kWindowRadius; x < width - kWindowRadius; ++x) {
    const int h = smooth(x + 2) - smooth(x - 2) + 2 * (smooth(x + 1) - smooth(x - 1));
    const int v = slope(x - 2) + slope(x + 2) + 4 * (slope(x - 1) + slope(x + 1)) + 6 * slope(x);
    const int dd =
        2 * (e[x + 2] - a[x - 2]) + 4 * (d[x + 1] - b[x - 1]) +
        2 * (d[x + 2] + e[x + 1] - b[x - 2] - a[x - 1]) + 3 * (c[x + 1] + d[x] - c[x - 1] - b[x]) +
        3 * (c[x + 2] + e[x] - c[x - 2] - a[x]) + (b[x + 2] + e[x - 1] - a[x + 1] - d[x - 2]);
    const int ee =
        2 * (e[x - 2] - a[x + 2]) + 4 * (d[x - 1] - b[x + 1]) +
        2 * (d[x - 2] + e[x - 1] - b[x + 2] - a[x + 1]) + 3 * (c[x - 1] + d[x] - c[x + 1] - b[x]) +
        3 * (c[x - 2] + e[x] - c[x + 2] - a[x]) + (b[x - 2] + e[x + 1] - a[x - 1] - d[x + 2]);
    gx[x] = static_cast<std::int16_t>(round_shift(h + 4 * (dd - ee)));
    gy[x] = static_cast<std::int16_t>(round_shift(v + 4 * (dd + ee)));
    const int sum = std::abs(h) + std::abs(v) + 2 * (std::abs(dd) + std::abs(ee));
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
      rows.r[i] = grey + static_cast<std::ptrdiff_t>(y - kWindowRadius + i) * stride;
    }
    gradient_row(rows, width, image.gx.row(y), image.gy.row(y), image.magnitude.row(y));
  }
  return image;
}

}  // namespace trihedron::golden
