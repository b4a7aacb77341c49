// SPDX-License-Identifier: Apache-2.0
#include "golden/gradient.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

/// Fraction bits of the sums |H| + |V| + 4|D| + 4|E| and H + 8 (D - E) below 1/kGradientScale.
constexpr int kShift = 10 - kGradientFractionBits;
constexpr int kHalf = 1 << (kShift - 1);
static_assert(kGradientFractionBits >= 0 && kShift >= 1, "0 to 9 fraction bits");

/// Nearest integer to sum / 2^kShift, halves away from zero: mirrored images have mirrored slopes.
inline int round_shift(int sum) { return (sum + kHalf + (sum >> 31)) >> kShift; }

/// The four masks' sums of a block; each fits 16 bits (docs/stages/gradient.md).
struct Derivatives {
  std::int16_t h[kBlockPx], v[kBlockPx], d[kBlockPx], e[kBlockPx];
};

void axes(const WindowBlock& window, Derivatives& out) {
  const auto& [a, b, c, d, e] = window.rows;
  std::int16_t smooth[kBlockPx + 4];
  std::int16_t slope[kBlockPx + 4];
  for (int x = 0; x < kBlockPx + 4; ++x) {
    smooth[x] = static_cast<std::int16_t>(a[x] + 4 * (b[x] + d[x]) + 6 * c[x] + e[x]);
    slope[x] = static_cast<std::int16_t>(e[x] - a[x] + 6 * (d[x] - b[x]));
  }
  for (int x = 0; x < kBlockPx; ++x) {
    out.h[x] =
        static_cast<std::int16_t>(smooth[x + 4] - smooth[x] + 6 * (smooth[x + 3] - smooth[x + 1]));
    out.v[x] = static_cast<std::int16_t>(slope[x] + slope[x + 4] +
                                         4 * (slope[x + 1] + slope[x + 3]) + 6 * slope[x + 2]);
  }
}

/// Mask D; `s` = 1 looks down right, `s` = -1 mirrors it (mask E).
template <int s>
void diagonal(const WindowBlock& window, std::int16_t* out) {
  const auto& [a, b, c, d, e] = window.rows;
  for (int i = 0; i < kBlockPx; ++i) {
    const int x = i + kWindowRadius;
    out[i] = static_cast<std::int16_t>((e[x + 2 * s] - a[x - 2 * s]) + 4 * (d[x + s] - b[x - s]) +
                                       2 * (d[x + 2 * s] + e[x + s] - a[x - s] - b[x - 2 * s]) +
                                       5 * (c[x + s] + d[x] - b[x] - c[x - s]) +
                                       3 * (c[x + 2 * s] + e[x] - a[x] - c[x - 2 * s]) +
                                       (b[x + 2 * s] + e[x - s] - a[x + s] - d[x - 2 * s]));
  }
}

struct GradientBlock {
  std::int16_t gx[kBlockPx], gy[kBlockPx];
  std::uint16_t magnitude[kBlockPx];
};

void combine(const Derivatives& in, GradientBlock& out) {
  for (int x = 0; x < kBlockPx; ++x) {
    const int h = in.h[x];
    const int v = in.v[x];
    const int d = in.d[x];
    const int e = in.e[x];
    out.gx[x] = static_cast<std::int16_t>(round_shift(h + 8 * (d - e)));
    out.gy[x] = static_cast<std::int16_t>(round_shift(v + 8 * (d + e)));
    const int sum = std::abs(h) + std::abs(v) + 4 * (std::abs(d) + std::abs(e));
    out.magnitude[x] = static_cast<std::uint16_t>(std::min((sum + kHalf) >> kShift, kMaxMagnitude));
  }
}

}  // namespace

GradientImage gradient(const std::uint8_t* grey, int width, int height, int stride) {
  GradientImage image{Plane<std::int16_t>(width, height), Plane<std::int16_t>(width, height),
                      Plane<std::uint16_t>(width, height)};
  WindowBlock window;
  Derivatives derivatives;
  GradientBlock block;
  for (int y = kWindowRadius; y < height - kWindowRadius; ++y) {
    std::array<const std::uint8_t*, kMinFrameSide> rows{};
    for (int j = 0; j < kMinFrameSide; ++j) {
      rows[static_cast<std::size_t>(j)] =
          grey + static_cast<std::ptrdiff_t>(y - kWindowRadius + j) * stride;
    }
    for (int x = kWindowRadius; x < width - kWindowRadius; x += kBlockPx) {
      window.load(rows, x, width);
      axes(window, derivatives);
      diagonal<1>(window, derivatives.d);
      diagonal<-1>(window, derivatives.e);
      combine(derivatives, block);
      const int n = std::min(kBlockPx, width - kWindowRadius - x);
      std::copy_n(block.gx, n, image.gx.row(y) + x);
      std::copy_n(block.gy, n, image.gy.row(y) + x);
      std::copy_n(block.magnitude, n, image.magnitude.row(y) + x);
    }
  }
  return image;
}

}  // namespace trihedron::golden
