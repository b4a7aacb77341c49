// SPDX-License-Identifier: Apache-2.0
#include "golden/gradient.hpp"

#include <algorithm>
#include <array>

#include "golden/vector_clones.hpp"
#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

/// Fraction bits of the sums |H| + |V| + 4|D| + 4|E| and H + 8 (D - E) below 1/kGradientScale.
constexpr int kShift = 10 - kGradientFractionBits;
constexpr int kHalf = 1 << (kShift - 1);
static_assert(kGradientFractionBits >= 0 && kShift >= 4, "0 to 6 fraction bits");

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

/// (axis + 8 diagonals) / 2^kShift to nearest, halves away from zero: mirrored images have mirrored
/// slopes. The 3 bits that only `axis` has are cut off before the sum, which so fits 16 bits; the
/// floor of a floor is the floor of the whole.
inline std::int16_t slope_of(std::int16_t axis, std::int16_t diagonals) {
  const auto sign = static_cast<std::int16_t>(((axis >> 3) + diagonals) >> 15);
  const auto rounded = static_cast<std::int16_t>(axis + kHalf + sign);
  const auto sum = static_cast<std::int16_t>((rounded >> 3) + diagonals);
  return static_cast<std::int16_t>(sum >> (kShift - 3));
}

inline std::uint16_t size_of(std::int16_t value) {
  return static_cast<std::uint16_t>(value < 0 ? -value : value);
}

/// (|h| + |v| + 4 diagonals) / 2^kShift to nearest, in 16 bits as above.
inline std::uint16_t magnitude_of(std::uint16_t axes, std::uint16_t diagonals) {
  const auto rounded = static_cast<std::uint16_t>(axes + kHalf);
  const auto sum = static_cast<std::uint16_t>((rounded >> 2) + diagonals);
  const auto mean = static_cast<std::uint16_t>(sum >> (kShift - 2));
  return mean < kMaxMagnitude ? mean : static_cast<std::uint16_t>(kMaxMagnitude);
}

void combine(const Derivatives& in, GradientBlock& out) {
  for (int x = 0; x < kBlockPx; ++x) {
    out.gx[x] = slope_of(in.h[x], static_cast<std::int16_t>(in.d[x] - in.e[x]));
    out.gy[x] = slope_of(in.v[x], static_cast<std::int16_t>(in.d[x] + in.e[x]));
    out.magnitude[x] =
        magnitude_of(static_cast<std::uint16_t>(size_of(in.h[x]) + size_of(in.v[x])),
                     static_cast<std::uint16_t>(size_of(in.d[x]) + size_of(in.e[x])));
  }
}

}  // namespace

TRIHEDRON_VECTOR_CLONES
void gradient_row(const std::uint8_t* grey, int stride, int y, GradientImage& out) {
  clear_row(out.gx, y);
  clear_row(out.gy, y);
  if (!clear_row(out.magnitude, y)) return;
  std::array<const std::uint8_t*, kMinFrameSide> rows{};
  for (int j = 0; j < kMinFrameSide; ++j) {
    rows[static_cast<std::size_t>(j)] =
        grey + static_cast<std::ptrdiff_t>(y - kWindowRadius + j) * stride;
  }
  const int width = out.magnitude.width;
  WindowBlock window;
  Derivatives derivatives;
  GradientBlock block;
  for (int x = kWindowRadius; x < width - kWindowRadius; x += kBlockPx) {
    window.load(rows, x, width);
    axes(window, derivatives);
    diagonal<1>(window, derivatives.d);
    diagonal<-1>(window, derivatives.e);
    combine(derivatives, block);
    const int n = std::min(kBlockPx, width - kWindowRadius - x);
    store_block(block.gx, n, out.gx.row(y) + x);
    store_block(block.gy, n, out.gy.row(y) + x);
    store_block(block.magnitude, n, out.magnitude.row(y) + x);
  }
}

GradientImage gradient(const std::uint8_t* grey, int width, int height, int stride) {
  GradientImage image{Plane<std::int16_t>(width, height), Plane<std::int16_t>(width, height),
                      Plane<std::uint16_t>(width, height)};
  for (int y = 0; y < height; ++y) gradient_row(grey, stride, y, image);
  return image;
}

}  // namespace trihedron::golden
