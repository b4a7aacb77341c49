// SPDX-License-Identifier: Apache-2.0
#include "golden/vertices.hpp"

#include <algorithm>
#include <array>

#include "golden/set_pixels.hpp"
#include "golden/vector_clones.hpp"
#include "golden/vertex_ring.hpp"
#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

int lowest(unsigned bits) {
  int k = 0;
  while ((bits >> k & 1) == 0) ++k;
  return k;
}

int highest(unsigned bits) {
  int k = kRingPx - 1;
  while ((bits >> k & 1) == 0) --k;
  return k;
}

int count(unsigned bits) {
  int n = 0;
  for (; bits != 0; bits &= bits - 1) ++n;
  return n;
}

/// Per ring pixel the sectors whose contour runs along the radius, as bits. Sector s is centred at
/// s + 1/2; the perpendicular to the radius lies at 16 + 4 k sectors for even k, and at 16 + 4.72,
/// 16 + 11.28 (the tangents 1/2 and 2) and so on in between. Opposite pixels share their sectors.
constexpr std::array<std::uint32_t, kRingPx> sectors_along() {
  constexpr std::array<double, 4> kPerpendicular = {16, 20.7228, 24, 27.2772};
  constexpr double kWithin = 6.25;
  std::array<std::uint32_t, kRingPx> table{};
  for (unsigned k = 0; k < kRingPx; ++k) {
    const double middle = kPerpendicular[k % 4] + (k / 4 % 2) * 16;
    for (unsigned s = 0; s < 3 * kDirections; ++s) {
      const double off = s + 0.5 - middle;
      if (off <= kWithin && off >= -kWithin) table[k] |= 1U << s % kDirections;
    }
  }
  return table;
}
constexpr std::array<std::uint32_t, kRingPx> kAlong = sectors_along();

bool turns(Direction a, Direction b, int min_turn) {
  constexpr std::array<int, 4> kExtraTurn = {0, 5, 2, 0};
  const auto weaker = static_cast<std::size_t>(std::min(a, b) >> kDirectionBits);
  return turn_between(a, b) >= min_turn + kExtraTurn[weaker];
}

/// The direction as one of class 1.
Direction weakest(Direction d) {
  return static_cast<Direction>(1U << kDirectionBits | (d & (kDirections - 1U)));
}

/// Which of the n pixels from x on have a branch pixel among their 8 neighbours.
void beside_branch(const Plane<Direction>& directions, int x, int y, int n, std::uint8_t* out) {
  const Direction* above = directions.row(y - 1) + x;
  const Direction* at = directions.row(y) + x;
  const Direction* below = directions.row(y + 1) + x;
  for (int i = 0; i < n; ++i) {
    out[i] = above[i - 1] | above[i] | above[i + 1] | at[i - 1] | at[i + 1] | below[i - 1] |
             below[i] | below[i + 1];
  }
}

/// Whether no other score of 5 x 3 pixels is larger, and none before it in raster order equal.
bool is_peak(const Plane<std::uint16_t>& scores, int x, int y) {
  const std::uint16_t* above = scores.row(y - 1) + x;
  const std::uint16_t* at = scores.row(y) + x;
  const std::uint16_t* below = scores.row(y + 1) + x;
  const int before =
      std::max({int{*std::max_element(above - 2, above + 3)}, int{at[-2]}, int{at[-1]}});
  const int after =
      std::max({int{*std::max_element(below - 2, below + 3)}, int{at[1]}, int{at[2]}});
  return at[0] > before && at[0] >= after;
}

/// [1 4 6 4 1] over values `step` apart.
template <typename T>
int binomial(const T* at, std::ptrdiff_t step) {
  return at[-2 * step] + at[2 * step] + 4 * (at[-step] + at[step]) + 6 * at[0];
}

}  // namespace

bool vertex_value(const Plane<Direction>& directions, int x, int y, const VertexConfig& config) {
  const WindowBranches window = window_branches(directions, x, y);
  unsigned ring = window.ring;
  if (!window.inner || (ring & (ring - 1)) == 0) return false;
  const auto at = [&](int k) {
    const RingOffset o = kRing[static_cast<std::size_t>(k)];
    return directions.at(x + o.x, y + o.y);
  };
  for (unsigned rest = ring; rest != 0; rest &= rest - 1) {
    const int k = lowest(rest);
    const unsigned sector = at(k) & (kDirections - 1);
    if ((kAlong[static_cast<std::size_t>(k)] >> sector & 1) == 0) ring &= ~(1U << k);
  }
  const unsigned starts = run_starts(ring);
  const unsigned later = starts & (starts - 1);
  if (later == 0) return false;
  const auto branch = [&](int k) {
    const bool touches = (window.touching >> k & 1) != 0;
    return touches ? at(k) : weakest(at(k));
  };
  const Direction first = branch(lowest(starts)), second = branch(lowest(later)),
                  last = branch(highest(later));
  return turns(first, second, config.min_turn) || turns(first, last, config.min_turn);
}

void value_row(const Plane<Direction>& directions, const VertexConfig& config, int y,
               Plane<std::uint8_t>& out) {
  if (!clear_row(out, y)) return;
  std::uint8_t* value = out.row(y);
  std::uint8_t candidate[kBlockPx];
  for (int x = kWindowRadius; x < out.width - kWindowRadius; x += kBlockPx) {
    const int n = std::min(kBlockPx, out.width - kWindowRadius - x);
    beside_branch(directions, x, y, n, candidate);
    for_each_set(candidate, 0, n,
                 [&](int i) { value[x + i] = vertex_value(directions, x + i, y, config) ? 1 : 0; });
  }
}

TRIHEDRON_VECTOR_CLONES
void score_row(const Plane<std::uint8_t>& values, int y, Plane<std::uint16_t>& out) {
  if (!clear_row(out, y)) return;
  const auto rows = window_rows(values, y);
  std::uint8_t columns[kBlockPx + 2 * kWindowRadius];
  std::uint16_t* score = out.row(y);
  for (int x = kWindowRadius; x < out.width - kWindowRadius; x += kBlockPx) {
    const int n = std::min(kBlockPx, out.width - kWindowRadius - x);
    const int left = x - kWindowRadius;
    for (int i = 0; i < n + 2 * kWindowRadius; ++i) {
      const int c = left + i;
      columns[i] = static_cast<std::uint8_t>(rows[0][c] + rows[4][c] + 6 * rows[2][c] +
                                             4 * (rows[1][c] + rows[3][c]));
    }
    for (int i = 0; i < n; ++i) {
      score[x + i] = static_cast<std::uint16_t>(binomial(columns + kWindowRadius + i, 1) >> 2);
    }
  }
}

void append_vertices(const Plane<Direction>& directions, const Plane<std::uint16_t>& scores, int y,
                     std::vector<Vertex>& out) {
  if (y < kWindowRadius || y >= scores.height - kWindowRadius) return;
  const std::uint16_t* score = scores.row(y);
  for (int x = kWindowRadius; x < scores.width - kWindowRadius; ++x) {
    if (score[x] < kLeastScore || !is_peak(scores, x, y)) continue;
    const unsigned starts = run_starts(window_branches(directions, x, y).touching);
    Vertex vertex;
    vertex.x = static_cast<std::uint16_t>(x);
    vertex.y = static_cast<std::uint16_t>(y);
    vertex.branches = static_cast<std::uint8_t>(count(starts));
    if (starts != 0) {
      vertex.pattern = static_cast<std::uint16_t>(16 * lowest(starts) + highest(starts));
    }
    vertex.strength = score[x];
    out.push_back(vertex);
  }
}

std::vector<Vertex> vertices(const GradientImage& gradient,
                             const Plane<std::uint8_t>& second_contour,
                             const VertexConfig& config) {
  const Plane<Direction> direction = directions(gradient, second_contour, config.branch_floor);
  Plane<std::uint8_t> values(direction.width, direction.height);
  Plane<std::uint16_t> scores(direction.width, direction.height);
  for (int y = 0; y < values.height; ++y) value_row(direction, config, y, values);
  for (int y = 0; y < values.height; ++y) score_row(values, y, scores);
  std::vector<Vertex> found;
  for (int y = 0; y < values.height; ++y) append_vertices(direction, scores, y, found);
  return found;
}

}  // namespace trihedron::golden
