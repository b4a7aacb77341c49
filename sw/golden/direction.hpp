// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// What stage 4 keeps of a pixel: 0 where no vertex branch can run, else the class of its
/// magnitude in bits 6:5 (1 weak, 2 medium, 3 strong) and the direction of its gradient, without
/// its sign, in bits 4:0. Seven bits a pixel.
using Direction = std::uint8_t;

constexpr int kDirections = 32;    ///< sectors of a half turn, 5.625 degrees each
constexpr int kDirectionBits = 5;  ///< below the class

/// Sector of the gradient's direction modulo a half turn, 0 .. 31: 0 from the direction of x on,
/// rising towards that of y. A quarter turn of the gradient is 16 sectors exactly. Within an octant
/// the sector counts the thresholds 6 13 19 27 34 43 53, 64 tan(k 5.625 deg), that
/// 64 min(|gx|, |gy|) / max(|gx|, |gy|) reaches; sector 7 for no gradient.
int direction_sector(int gx, int gy);

/// Angle between two directions, 0 .. 16 sectors: contours have no sense, so at most a quarter
/// turn.
inline int turn_between(Direction a, Direction b) {
  const int difference = (a - b) & (kDirections - 1);
  return difference <= kDirections / 2 ? difference : kDirections - difference;
}

/// Class of a contour pixel's magnitude: 0 below `floor`, 1 below 3/2 of it, 2 below 5/2, 3 above.
int magnitude_class(int magnitude, int floor);

/// Row y of the directions of the second contour's pixels; 0 elsewhere.
void direction_row(const GradientImage& gradient, const Plane<std::uint8_t>& second_contour,
                   int floor, int y, Plane<Direction>& out);

/// All rows.
Plane<Direction> directions(const GradientImage& gradient,
                            const Plane<std::uint8_t>& second_contour, int floor);

}  // namespace trihedron::golden
