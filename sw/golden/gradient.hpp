// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/features.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Stage 1. Four 5x5 spline derivatives: H along x and V along y, 256 per grey level and px; D
/// down right and E down left, 64 times 3/4 of d/dy + d/dx and of d/dy - d/dx, that is 68 per
/// grey level and px along the diagonals:
///
///   H = smooth(y) (x) slope(x)          [-1 -2 -3 -1  0]
///   V = transpose of H                  [-2 -4 -5  0  1]
///   slope  = [-1 -6 0 6 1]         D =  [-3 -5  0  5  3]     E = D mirrored left to right
///   smooth = [1 4 6 4 1]                [-1  0  5  4  2]
///                                       [ 0  1  3  2  1]
///
///   magnitude = min((|H| + |V| + 4|D| + 4|E|) / 1024, 64 - 1/scale)   mean of the four
///   gx        = (H + 8 (D - E)) / 1024                                their common slope
///   gy        = (V + 8 (D + E)) / 1024
///
/// in units of 1/kGradientScale grey level per px, each rounded to nearest, halves away from
/// zero. |gx|, |gy| < 96 grey levels per px; the magnitude is 0.62 to 0.69 times the length of
/// (gx, gy), depending on the direction. docs/stages/gradient.md derives masks and widths.
struct GradientImage {
  Plane<std::int16_t> gx;
  Plane<std::int16_t> gy;
  Plane<std::uint16_t> magnitude;  ///< kMagnitudeBits wide
};

/// Width of the magnitude, bits: it saturates at 64 grey levels per px.
constexpr int kMagnitudeBits = 6 + kGradientFractionBits;
constexpr int kMaxMagnitude = (1 << kMagnitudeBits) - 1;

/// Width of gx and gy with sign, bits.
constexpr int kSlopeBits = 8 + kGradientFractionBits;

/// Row y of the gradient of an 8-bit grey image of the frame of `out`, rows `stride` bytes apart.
void gradient_row(const std::uint8_t* grey, int stride, int y, GradientImage& out);

/// The gradient of an 8-bit grey image of `width` x `height` px, rows `stride` bytes apart. A
/// pixel whose window leaves the image has gradient 0.
GradientImage gradient(const std::uint8_t* grey, int width, int height, int stride);

}  // namespace trihedron::golden
