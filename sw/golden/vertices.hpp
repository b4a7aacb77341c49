// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/direction.hpp"
#include "golden/features.hpp"
#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Registers of stage 4, with their reset values.
struct VertexConfig {
  /// Smallest magnitude of a vertex branch, 1/kGradientScale grey level per px; 1 .. 511. Reset:
  /// the noise of a slope, 0.65 grey levels per px at sigma 3, turns the gradient of a contour of
  /// that magnitude by 10 degrees.
  int branch_floor = 20;
  /// Smallest turn between two strong branches, 5.625 degrees; 1 .. 16. Reset: 34 degrees. With
  /// that noise it takes 4 sigma: 55, 37, 22 degrees at the lower ends of the three classes, hence
  /// 5 and 2 more for the weaker ones; and one sector for the staircase of the pixels.
  int min_turn = 6;
};

/// Stage 4, first window: the vertex value, 1 where the 5x5 window looks like one around a vertex,
/// else 0; the centre need not be contour.
///
/// A branch pixel of the window's ring of 16 counts when its contour runs along the radius: its
/// direction is within 6.25 sectors, 35 degrees, of the perpendicular to its position. Runs of such
/// pixels are branches, known by their first pixel from the right towards below. A branch whose
/// first pixel touches no inner branch pixel is of class 1: beside a strong contour a weak one that
/// meets it has no ridge, so a stem may end two pixels short of its crossbar. The value is 1 when
/// from the first to the second or to the last branch the direction turns by at least min_turn + 5,
/// + 2 or + 0 with the weaker one of class 1, 2 or 3, and an inner pixel is a branch pixel.
bool vertex_value(const Plane<Direction>& directions, int x, int y, const VertexConfig& config);

/// Row y of the vertex values. A pixel whose 5x5 window leaves the image has 0.
void value_row(const Plane<Direction>& directions, const VertexConfig& config, int y,
               Plane<std::uint8_t>& out);

/// Stage 4, second window: row y of the vertex score, 0 .. 64: a quarter, rounded down, of the sum
/// of the 5x5 window's values with the weights [1 4 6 4 1] (x) [1 4 6 4 1].
void score_row(const Plane<std::uint8_t>& values, int y, Plane<std::uint16_t>& out);

/// Least score of a vertex: a square of four pixels, (36 + 24 + 24 + 16) / 4. Three have 21.
constexpr int kLeastScore = 25;

/// Appends the vertices of row y, from left to right: where the score is at least kLeastScore and
/// the largest of the 5x3 pixels around it, the first in raster order of equal ones. A pixel whose
/// 5x5 window leaves the image is no vertex. Branches and pattern are those of the ring around the
/// vertex without regard to their directions: its runs, and 16 a + b of the first and the last one.
void append_vertices(const Plane<Direction>& directions, const Plane<std::uint16_t>& scores, int y,
                     std::vector<Vertex>& out);

/// Stage 4, all rows.
std::vector<Vertex> vertices(const GradientImage& gradient,
                             const Plane<std::uint8_t>& second_contour, const VertexConfig& config);

}  // namespace trihedron::golden
