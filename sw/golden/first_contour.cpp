// SPDX-License-Identifier: Apache-2.0
#include "golden/first_contour.hpp"

#include <array>

namespace trihedron::golden {
namespace {

/// The five rows of the window, centre row in the middle.
using WindowRows = std::array<const std::uint16_t*, kMinFrameSide>;

/// Whether the centre outweighs the neighbours that are not above it. The centre adds itself to
/// the sum and to the count: both are taken out again.
inline bool outweighs(const WindowRows& rows, int x, int mean_limit) {
  const std::uint16_t centre = rows[2][x];
  std::uint16_t sum = 0;
  std::uint16_t count = 0;
  for (const std::uint16_t* row : rows) {
    for (int i = -kWindowRadius; i <= kWindowRadius; ++i) {
      const std::uint16_t n = row[x + i];
      sum = static_cast<std::uint16_t>(sum + (n <= centre ? n : 0));
      count = static_cast<std::uint16_t>(count + (n <= centre ? 1 : 0));
    }
  }
  return 32 * (sum - centre) < mean_limit * centre * (count - 1);
}

/// Whether two inner neighbours that do not touch each other are at least 3/4 of the centre.
inline bool path_passes(const WindowRows& rows, int x) {
  const int least = 3 * rows[2][x];
  const auto on = [&](int i, int j) { return 4 * rows[2 + j][x + i] >= least; };
  const bool nw = on(-1, -1), n = on(0, -1), ne = on(1, -1), w = on(-1, 0);
  const bool e = on(1, 0), sw = on(-1, 1), s = on(0, 1), se = on(1, 1);
  const bool straight = (n & s) | (w & e);
  const bool bent = (n & (sw | se)) | (s & (nw | ne)) | (w & (ne | se)) | (e & (nw | sw));
  const bool two_corners = (nw & (ne | sw | se)) | (ne & (sw | se)) | (sw & se);
  return straight | bent | two_corners;
}

}  // namespace

Plane<std::uint8_t> first_contour(const Plane<std::uint16_t>& magnitude,
                                  const FirstContourConfig& config) {
  Plane<std::uint8_t> contour(magnitude.width, magnitude.height);
  for (int y = kWindowRadius; y < magnitude.height - kWindowRadius; ++y) {
    WindowRows rows;
    for (int i = 0; i < kMinFrameSide; ++i) rows[i] = magnitude.row(y - kWindowRadius + i);
    std::uint8_t* out = contour.row(y);
    for (int x = kWindowRadius; x < magnitude.width - kWindowRadius; ++x) {
      out[x] = (rows[2][x] >= config.noise_floor) & outweighs(rows, x, config.mean_limit) &
               path_passes(rows, x);
    }
  }
  return contour;
}

}  // namespace trihedron::golden
