// SPDX-License-Identifier: Apache-2.0
#include "golden/second_contour.hpp"

#include <algorithm>
#include <array>

#include "golden/set_pixels.hpp"
#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

/// The 8 neighbours in turn around the centre: right, then towards lower right, and so on. The
/// even ones share a side with the centre.
struct Offset {
  int x;
  int y;
};
constexpr std::array<Offset, 8> kAround = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

unsigned links(const Plane<std::uint8_t>& ridge, int x, int y) {
  unsigned bits = 0;
  for (unsigned k = 0; k < kAround.size(); ++k) {
    bits |= static_cast<unsigned>(ridge.at(x + kAround[k].x, y + kAround[k].y)) << k;
  }
  return bits;
}

int count(unsigned bits) {
  int n = 0;
  for (; bits != 0; bits &= bits - 1) ++n;
  return n;
}

/// Whether the links fall into two or more groups that do not touch. A corner between two side
/// neighbours does not part them, so it counts as set: then groups are runs around the ring.
bool apart(unsigned bits) {
  unsigned sides = bits & 0x55U;
  const unsigned next_side = (sides >> 2 | sides << 6) & 0x55U;
  const unsigned filled = bits | (sides & next_side) << 1;
  const unsigned previous = (filled << 1 | filled >> 7) & 0xFFU;
  return count(filled & ~previous) >= 2;
}

/// Whether one of the links is an end of a piece: its only link is on its far side.
bool at_end(const Plane<std::uint8_t>& ridge, int x, int y, unsigned bits) {
  for (unsigned k = 0; k < kAround.size(); ++k) {
    if ((bits >> k & 1) == 0) continue;
    if (count(links(ridge, x + kAround[k].x, y + kAround[k].y)) == 1) return true;
  }
  return false;
}

/// Which of the n pixels from x on have a link.
void linked(const Plane<std::uint8_t>& ridge, int x, int y, int n, std::uint8_t* out) {
  const std::uint8_t* above = ridge.row(y - 1) + x;
  const std::uint8_t* at = ridge.row(y) + x;
  const std::uint8_t* below = ridge.row(y + 1) + x;
  for (int i = 0; i < n; ++i) {
    out[i] = above[i - 1] | above[i] | above[i + 1] | at[i - 1] | at[i + 1] | below[i - 1] |
             below[i] | below[i + 1];
  }
}

}  // namespace

void link_row(const Plane<std::uint8_t>& ridge, const Plane<std::uint16_t>& magnitude,
              int noise_floor, int y, Plane<std::uint8_t>& out) {
  if (!clear_row(out, y)) return;
  const std::uint8_t* at = ridge.row(y);
  const std::uint16_t* level = magnitude.row(y);
  std::uint8_t* contour = out.row(y);
  std::uint8_t has_link[kBlockPx];
  for (int x = kWindowRadius; x < out.width - kWindowRadius; x += kBlockPx) {
    const int n = std::min(kBlockPx, out.width - kWindowRadius - x);
    linked(ridge, x, y, n, has_link);
    for_each_set(has_link, 0, n, [&](int i) {
      if (at[x + i] == 0) {
        if (level[x + i] < noise_floor) return;
        const unsigned bits = links(ridge, x + i, y);
        if (!apart(bits) || !at_end(ridge, x + i, y, bits)) return;
      }
      contour[x + i] = 1;
    });
  }
}

Plane<std::uint8_t> link(const Plane<std::uint8_t>& ridge, const Plane<std::uint16_t>& magnitude,
                         int noise_floor) {
  Plane<std::uint8_t> contour(ridge.width, ridge.height);
  for (int y = 0; y < contour.height; ++y) link_row(ridge, magnitude, noise_floor, y, contour);
  return contour;
}

}  // namespace trihedron::golden
