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

/// The branch pixels (direction not 0) of a window but for its centre. Ring: bit k for kRing[k].
struct WindowBranches {
  unsigned ring;      ///< branch pixels of the ring
  unsigned touching;  ///< those that touch an inner branch pixel
  bool inner;         ///< whether one of the 8 inner pixels is a branch pixel
};

/// Those around (x, y), which needs a whole window.
WindowBranches window_branches(const Plane<Direction>& directions, int x, int y);

/// The first pixel of each run of set bits around the ring.
constexpr unsigned run_starts(unsigned ring) { return ring & ~(ring << 1 | ring >> (kRingPx - 1)); }

}  // namespace trihedron::golden
