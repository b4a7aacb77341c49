// SPDX-License-Identifier: Apache-2.0
#include "golden/first_contour.hpp"

#include <algorithm>

#include "golden/vector_clones.hpp"
#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

/// One flag a pixel, 0 or 1, as wide as the values it comes from.
using Flags = std::int16_t[kBlockPx];

/// The values of five neighbours side by side that are not above the centre: their sum and count.
/// One pixel of what outweighs() does for a row of windows.
inline void add_row(const std::int16_t* n, std::int16_t centre, std::int16_t& sum,
                    std::int16_t& count) {
  const auto mask = [centre](std::int16_t value) {
    return static_cast<std::int16_t>(-(value <= centre));
  };
  const std::int16_t a = mask(n[0]), b = mask(n[1]), c = mask(n[2]), d = mask(n[3]), e = mask(n[4]);
  sum = static_cast<std::int16_t>(sum + (n[0] & a) + (n[1] & b) + (n[2] & c) + (n[3] & d) +
                                  (n[4] & e));
  count = static_cast<std::int16_t>(count - a - b - c - d - e);
}

/// Whether the centre outweighs the neighbours that are not above it. The centre adds itself to
/// the sum and to the count: both are taken out again.
void outweighs(const WindowBlock& window, int mean_limit, Flags& flags) {
  const auto& [r0, r1, r2, r3, r4] = window.rows;
  for (int x = 0; x < kBlockPx; ++x) {
    const std::int16_t centre = r2[x + kWindowRadius];
    std::int16_t sum = 0;
    std::int16_t count = 0;
    for (const std::int16_t* row : {r0, r1, r2, r3, r4}) add_row(row + x, centre, sum, count);
    const int others = sum - centre;
    flags[x] = 32 * others < mean_limit * centre * (count - 1) ? 1 : 0;
  }
}

/// Whether two inner neighbours that do not touch each other are at least 3/4 of the centre.
void path_passes(const WindowBlock& window, Flags& flags) {
  Flags on[3][3];
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      for (int x = 0; x < kBlockPx; ++x) {
        const auto least = static_cast<std::int16_t>(3 * window.rows[2][x + 2]);
        const auto level = static_cast<std::int16_t>(4 * window.rows[j + 1][x + i + 1]);
        on[j][i][x] = level >= least ? 1 : 0;
      }
    }
  }
  const auto& [nw, n, ne] = on[0];
  const auto& [w, centre, e] = on[1];
  const auto& [sw, s, se] = on[2];
  for (int x = 0; x < kBlockPx; ++x) {
    const int straight = (n[x] & s[x]) | (w[x] & e[x]);
    const int bent = (n[x] & (sw[x] | se[x])) | (s[x] & (nw[x] | ne[x])) |
                     (w[x] & (ne[x] | se[x])) | (e[x] & (nw[x] | sw[x]));
    const int corners =
        (nw[x] & (ne[x] | sw[x] | se[x])) | (ne[x] & (sw[x] | se[x])) | (sw[x] & se[x]);
    flags[x] = static_cast<std::int16_t>(straight | bent | corners);
  }
}

}  // namespace

TRIHEDRON_VECTOR_CLONES
void first_contour_row(const Plane<std::uint16_t>& magnitude, const FirstContourConfig& config,
                       int y, Plane<std::uint8_t>& out) {
  if (!clear_row(out, y)) return;
  WindowBlock window;
  Flags heavy;
  Flags path;
  const auto rows = window_rows(magnitude, y);
  const std::uint16_t* centre = magnitude.row(y);
  std::uint8_t* first = out.row(y);
  for (int x = kWindowRadius; x < magnitude.width - kWindowRadius; x += kBlockPx) {
    const int n = std::min(kBlockPx, magnitude.width - kWindowRadius - x);
    int highest = 0;
    for (int i = 0; i < n; ++i) highest = std::max<int>(highest, centre[x + i]);
    if (highest < config.noise_floor) continue;
    window.load(rows, x, magnitude.width);
    outweighs(window, config.mean_limit, heavy);
    path_passes(window, path);
    for (int i = 0; i < n; ++i) {
      const bool above_noise = centre[x + i] >= config.noise_floor;
      first[x + i] = static_cast<std::uint8_t>(above_noise & heavy[i] & path[i]);
    }
  }
}

Plane<std::uint8_t> first_contour(const Plane<std::uint16_t>& magnitude,
                                  const FirstContourConfig& config) {
  Plane<std::uint8_t> contour(magnitude.width, magnitude.height);
  for (int y = 0; y < contour.height; ++y) first_contour_row(magnitude, config, y, contour);
  return contour;
}

}  // namespace trihedron::golden
