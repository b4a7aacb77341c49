// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "golden/direction.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

constexpr int kRingPx = 16;  ///< outer pixels of a 5x5 window

struct RingOffset {
  int x;
  int y;
};

/// The outer pixels, from the right towards below.
constexpr std::array<RingOffset, kRingPx> kRing = {{{2, 0},
                                                    {2, 1},
                                                    {2, 2},
                                                    {1, 2},
                                                    {0, 2},
                                                    {-1, 2},
                                                    {-2, 2},
                                                    {-2, 1},
                                                    {-2, 0},
                                                    {-2, -1},
                                                    {-2, -2},
                                                    {-1, -2},
                                                    {0, -2},
                                                    {1, -2},
                                                    {2, -2},
                                                    {2, -1}}};

/// The ring's pixels that are branch pixels (direction not 0) and touch a branch pixel among the 8
/// inner ones: bit k for kRing[k]. (x, y) needs a whole window.
unsigned touching_ring(const Plane<Direction>& directions, int x, int y);

/// The first pixel of each run of set bits around the ring.
constexpr unsigned run_starts(unsigned ring) { return ring & ~(ring << 1 | ring >> (kRingPx - 1)); }

}  // namespace trihedron::golden
