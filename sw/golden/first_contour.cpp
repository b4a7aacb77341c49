// SPDX-License-Identifier: Apache-2.0
#include "golden/first_contour.hpp"

#include <algorithm>

#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

/// One flag a pixel, 0 or 1, as wide as the values it comes from.
using Flags = std::int16_t[kBlockPx];

/// Whether the centre outweighs the neighbours that are not above it. The centre adds itself to
/// the sum and to the count: both are taken out again.
void outweighs(const WindowBlock& window, int mean_limit, Flags& flags) {
  std::int16_t sum[kBlockPx] = {};
  std::int16_t count[kBlockPx] = {};
  const std::int16_t* centre = window.rows[kWindowRadius] + kWindowRadius;
  for (const auto& row : window.rows) {
    for (int i = 0; i < kMinFrameSide; ++i) {
      for (int x = 0; x < kBlockPx; ++x) {
        const std::int16_t n = row[x + i];
        const auto mask = static_cast<std::int16_t>(-(n <= centre[x]));
        sum[x] = static_cast<std::int16_t>(sum[x] + (n & mask));
        count[x] = static_cast<std::int16_t>(count[x] - mask);
      }
    }
  }
  for (int x = 0; x < kBlockPx; ++x) {
    const int others = sum[x] - centre[x];
    flags[x] = 32 * others < mean_limit * centre[x] * (count[x] - 1) ? 1 : 0;
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

Plane<std::uint8_t> first_contour(const Plane<std::uint16_t>& magnitude,
                                  const FirstContourConfig& config) {
  Plane<std::uint8_t> contour(magnitude.width, magnitude.height);
  WindowBlock window;
  Flags heavy;
  Flags path;
  for (int y = kWindowRadius; y < magnitude.height - kWindowRadius; ++y) {
    const auto rows = window_rows(magnitude, y);
    const std::uint16_t* centre = magnitude.row(y);
    std::uint8_t* out = contour.row(y);
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
        out[x + i] = static_cast<std::uint8_t>(above_noise & heavy[i] & path[i]);
      }
    }
  }
  return contour;
}

}  // namespace trihedron::golden
