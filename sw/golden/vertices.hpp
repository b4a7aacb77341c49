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
  /// Smallest turn of the gradient between two strong branches, 1/64 of a full turn; 1 .. 27.
  /// Reset: 28 degrees. With that noise it takes 4 sigma: 55, 37, 22 degrees at the lower ends of
  /// the three classes, hence 5 and 2 more for the weaker ones.
  int min_turn = 5;
};

/// Stage 4, first window: the vertex value of one pixel from the directions around it.
///
/// The 16 outer pixels of the 5x5 window, numbered from the right towards below, form branches:
/// runs of branch pixels (direction not 0) that touch an inner one. A branch is known by its first
/// pixel.
///   Two branches a and b: turn = angle between their directions, 0 .. 32; bend = 8 - distance of
///   a and b on the ring of 16 (0 straight, 8 folded). A corner when turn >= min_turn + 5, + 2 or
///   + 0 with the weaker branch of class 1, 2 or 3; strength = turn + bend.
///   Three or more: a junction of strength 96, 32 more when the inner ring of 8 has three or more
///   runs as well, less 2 (|X| + |Y|) with (X, Y) the sum of the branches' positions.
/// Pattern: 16 a + b, for junctions of the first and the last branch.
struct VertexValue {
  std::uint8_t strength = 0;  ///< 0: no vertex
  std::uint8_t branches = 0;
  std::uint8_t pattern = 0;
};

VertexValue vertex_value(const Plane<Direction>& directions, int x, int y,
                         const VertexConfig& config);

/// Row y of the vertex values' strengths.
void strength_row(const Plane<Direction>& directions, const VertexConfig& config, int y,
                  Plane<std::uint8_t>& out);

/// Appends the vertices of row y: where the vertex value is the largest of its 5x5 window, the
/// first in raster order of equal ones; from left to right. A pixel whose 5x5 window leaves the
/// image is no vertex.
void append_vertices(const Plane<Direction>& directions, const Plane<std::uint8_t>& strength,
                     const VertexConfig& config, int y, std::vector<Vertex>& out);

/// Stage 4, all rows.
std::vector<Vertex> vertices(const GradientImage& gradient,
                             const Plane<std::uint8_t>& second_contour, const VertexConfig& config);

}  // namespace trihedron::golden
