// SPDX-License-Identifier: Apache-2.0
#include "golden/vertices.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "golden/set_pixels.hpp"

namespace trihedron::golden {
namespace {

struct Offset {
  int x;
  int y;
};

constexpr std::array<Offset, 8> kInner = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

constexpr std::array<Offset, 16> kOuter = {{{2, 0},
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

/// Per outer pixel the inner ones that touch it, as bits.
constexpr std::array<unsigned, 16> touching_inner() {
  std::array<unsigned, 16> masks{};
  for (unsigned k = 0; k < 16; ++k) {
    for (unsigned i = 0; i < 8; ++i) {
      const int dx = kOuter[k].x - kInner[i].x;
      const int dy = kOuter[k].y - kInner[i].y;
      if (dx >= -1 && dx <= 1 && dy >= -1 && dy <= 1) masks[k] |= 1U << i;
    }
  }
  return masks;
}
constexpr std::array<unsigned, 16> kTouchingInner = touching_inner();

int count(unsigned bits) {
  int n = 0;
  for (; bits != 0; bits &= bits - 1) ++n;
  return n;
}

/// The first pixel of each run of set bits around a ring of `size`.
unsigned run_starts(unsigned bits, unsigned size) {
  return bits & ~(bits << 1 | bits >> (size - 1));
}

/// Angle between two directions, 1/64 turns, 0 .. 32.
int turn_between(Direction a, Direction b) {
  const int difference = std::abs((a & (kDirections - 1)) - (b & (kDirections - 1)));
  return std::min(difference, kDirections - difference);
}

int corner_strength(Direction a, Direction b, int first, int last, int min_turn) {
  constexpr int kExtraTurn[4] = {0, 5, 2, 0};
  const int turn = turn_between(a, b);
  if (turn < min_turn + kExtraTurn[std::min(a >> 6, b >> 6)]) return 0;
  const int apart = last - first;
  return turn + 8 - std::min(apart, 16 - apart);
}

int junction_strength(unsigned starts, unsigned inner) {
  int x = 0;
  int y = 0;
  for (unsigned k = 0; k < 16; ++k) {
    if ((starts >> k & 1) == 0) continue;
    x += kOuter[k].x;
    y += kOuter[k].y;
  }
  const int exact = count(run_starts(inner, 8)) >= 3 ? 32 : 0;
  return 96 + exact - 2 * (std::abs(x) + std::abs(y));
}

/// Whether no other value of the 5x5 window is larger, and none before it in raster order equal.
bool strongest(const Plane<std::uint8_t>& strength, int x, int y) {
  const int centre = strength.at(x, y);
  for (int j = -kWindowRadius; j <= kWindowRadius; ++j) {
    for (int i = -kWindowRadius; i <= kWindowRadius; ++i) {
      const bool before = j < 0 || (j == 0 && i < 0);
      if (strength.at(x + i, y + j) >= centre + (before ? 0 : 1)) return false;
    }
  }
  return true;
}

}  // namespace

VertexValue vertex_value(const Plane<Direction>& directions, int x, int y,
                         const VertexConfig& config) {
  unsigned inner = 0;
  for (unsigned k = 0; k < 8; ++k) {
    inner |= (directions.at(x + kInner[k].x, y + kInner[k].y) != 0 ? 1U : 0U) << k;
  }
  unsigned outer = 0;
  for (unsigned k = 0; k < 16; ++k) {
    const bool on = directions.at(x + kOuter[k].x, y + kOuter[k].y) != 0;
    outer |= (on && (inner & kTouchingInner[k]) != 0 ? 1U : 0U) << k;
  }
  const unsigned starts = run_starts(outer, 16);
  const int branches = count(starts);
  VertexValue value;
  if (branches < 2) return value;
  int first = 0;
  while ((starts >> first & 1) == 0) ++first;
  int last = 15;
  while ((starts >> last & 1) == 0) --last;
  const auto at = [&](int k) {
    const Offset o = kOuter[static_cast<std::size_t>(k)];
    return directions.at(x + o.x, y + o.y);
  };
  const int strength = branches >= 3
                           ? junction_strength(starts, inner)
                           : corner_strength(at(first), at(last), first, last, config.min_turn);
  if (strength <= 0) return value;
  value.strength = static_cast<std::uint8_t>(strength);
  value.branches = static_cast<std::uint8_t>(branches);
  value.pattern = static_cast<std::uint8_t>(16 * first + last);
  return value;
}

void strength_row(const Plane<Direction>& directions, const VertexConfig& config, int y,
                  Plane<std::uint8_t>& out) {
  if (!clear_row(out, y)) return;
  std::uint8_t* strength = out.row(y);
  for_each_set(directions.row(y), kWindowRadius, out.width - kWindowRadius,
               [&](int x) { strength[x] = vertex_value(directions, x, y, config).strength; });
}

void append_vertices(const Plane<Direction>& directions, const Plane<std::uint8_t>& strength,
                     const VertexConfig& config, int y, std::vector<Vertex>& out) {
  if (y < kWindowRadius || y >= strength.height - kWindowRadius) return;
  for_each_set(strength.row(y), kWindowRadius, strength.width - kWindowRadius, [&](int x) {
    if (!strongest(strength, x, y)) return;
    const VertexValue value = vertex_value(directions, x, y, config);
    Vertex vertex;
    vertex.x = static_cast<std::uint16_t>(x);
    vertex.y = static_cast<std::uint16_t>(y);
    vertex.branches = value.branches;
    vertex.pattern = value.pattern;
    vertex.strength = value.strength;
    out.push_back(vertex);
  });
}

std::vector<Vertex> vertices(const GradientImage& gradient,
                             const Plane<std::uint8_t>& second_contour,
                             const VertexConfig& config) {
  const Plane<Direction> direction = directions(gradient, second_contour, config.branch_floor);
  Plane<std::uint8_t> strength(direction.width, direction.height);
  for (int y = 0; y < strength.height; ++y) strength_row(direction, config, y, strength);
  std::vector<Vertex> found;
  for (int y = 0; y < strength.height; ++y) append_vertices(direction, strength, config, y, found);
  return found;
}

}  // namespace trihedron::golden
