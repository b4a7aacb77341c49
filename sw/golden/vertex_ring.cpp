// SPDX-License-Identifier: Apache-2.0
#include "golden/vertex_ring.hpp"

#include <cstdlib>

namespace trihedron::golden {
namespace {

/// A window's pixels as bits, 5 row + column. Per row and its 5 bits: the ring's pixels in bits
/// 15:0 and the inner ones in bits 23:16, in the order of kInner.
constexpr std::array<RingOffset, 8> kInner = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

using RowBits = std::array<std::array<std::uint32_t, 32>, kMinFrameSide>;
constexpr RowBits rings_of_rows() {
  RowBits table{};
  for (int row = 0; row < kMinFrameSide; ++row) {
    for (unsigned bits = 0; bits < 32; ++bits) {
      const auto on = [&](RingOffset o) {
        return o.y + kWindowRadius == row && (bits >> (o.x + kWindowRadius) & 1) != 0;
      };
      std::uint32_t rings = 0;
      for (unsigned k = 0; k < kRing.size(); ++k) rings |= (on(kRing[k]) ? 1U : 0U) << k;
      for (unsigned k = 0; k < kInner.size(); ++k) rings |= (on(kInner[k]) ? 1U : 0U) << (16 + k);
      table[static_cast<std::size_t>(row)][bits] = rings;
    }
  }
  return table;
}
constexpr RowBits kRings = rings_of_rows();

/// Per set of inner pixels the ring's pixels that touch one of them.
constexpr std::array<std::uint16_t, 256> touched_by_inner() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned inner = 0; inner < 256; ++inner) {
    for (unsigned k = 0; k < kRing.size(); ++k) {
      for (unsigned i = 0; i < kInner.size(); ++i) {
        const int dx = kRing[k].x - kInner[i].x;
        const int dy = kRing[k].y - kInner[i].y;
        const bool touches = dx >= -1 && dx <= 1 && dy >= -1 && dy <= 1;
        if (touches && (inner >> i & 1) != 0) table[inner] |= static_cast<std::uint16_t>(1U << k);
      }
    }
  }
  return table;
}
constexpr std::array<std::uint16_t, 256> kTouched = touched_by_inner();

/// Which of five bytes are not 0, the first in bit 0. Directions leave bit 7 free.
unsigned set_bytes(const Direction* at) {
  std::uint32_t four;
  std::memcpy(&four, at, sizeof four);
  const std::uint32_t tops = (four + 0x7F7F7F7FU) & 0x80808080U;
  return (tops >> 7) * 0x10204080U >> 28 | (at[4] != 0 ? 16U : 0U);
}

}  // namespace

WindowBranches window_branches(const Plane<Direction>& directions, int x, int y) {
  std::uint32_t rings = 0;
  for (int row = 0; row < kMinFrameSide; ++row) {
    const Direction* at = directions.row(y + row - kWindowRadius) + x - kWindowRadius;
    rings |= kRings[static_cast<std::size_t>(row)][set_bytes(at)];
  }
  const unsigned ring = rings & 0xFFFFU;
  const unsigned inner = rings >> 16;
  return {ring, ring & kTouched[inner], inner != 0};
}

}  // namespace trihedron::golden
