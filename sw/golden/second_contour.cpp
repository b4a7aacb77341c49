// SPDX-License-Identifier: Apache-2.0
#include "golden/second_contour.hpp"

#include <array>

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

}  // namespace

Plane<std::uint8_t> link(const Plane<std::uint8_t>& ridge, const Plane<std::uint16_t>& magnitude,
                         int noise_floor) {
  Plane<std::uint8_t> contour(ridge.width, ridge.height);
  for (int y = kWindowRadius; y < ridge.height - kWindowRadius; ++y) {
    const std::uint8_t* above = ridge.row(y - 1);
    const std::uint8_t* at = ridge.row(y);
    const std::uint8_t* below = ridge.row(y + 1);
    for (int x = kWindowRadius; x < ridge.width - kWindowRadius; ++x) {
      const bool linked = (above[x - 1] | above[x] | above[x + 1] | at[x - 1] | at[x + 1] |
                           below[x - 1] | below[x] | below[x + 1]) != 0;
      if (!linked) continue;
      const unsigned bits = links(ridge, x, y);
      contour.at(x, y) =
          at[x] || (magnitude.at(x, y) >= noise_floor && apart(bits) && at_end(ridge, x, y, bits));
    }
  }
  return contour;
}

}  // namespace trihedron::golden
