// SPDX-License-Identifier: Apache-2.0
// Branches and value of a window, said once more from their definition, in degrees.
#include "golden/vertex_ring.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "golden/vertices.hpp"

namespace trihedron::golden {
namespace {

using Directions = Plane<Direction>;

/// The ring from the right towards below, as columns and rows of a 5x5 window.
std::vector<std::pair<int, int>> ring_by_definition() {
  std::vector<std::pair<int, int>> ring{{4, 2}, {4, 3}};
  for (int i = 4; i > 0; --i) ring.emplace_back(i, 4);
  for (int i = 4; i > 0; --i) ring.emplace_back(0, i);
  for (int i = 0; i < 4; ++i) ring.emplace_back(i, 0);
  ring.insert(ring.end(), {{4, 0}, {4, 1}});
  return ring;
}

/// Whether an inner branch pixel lies within `reach` px of (x, y), in rows and in columns.
bool inner_near(const Directions& d, int x, int y, int reach) {
  for (int v = 1; v < 4; ++v) {
    for (int u = 1; u < 4; ++u) {
      const bool inner = (u != 2 || v != 2) && d.at(u, v) != 0;
      if (inner && std::abs(u - x) <= reach && std::abs(v - y) <= reach) return true;
    }
  }
  return false;
}

/// Branches from the definition: outer pixels that touch an inner one, flooded along the ring.
int branches_by_definition(const Directions& d) {
  std::vector<bool> on;
  for (const auto& [x, y] : ring_by_definition()) {
    on.push_back(inner_near(d, x, y, 1) && d.at(x, y) != 0);
  }
  int changes = 0;
  for (std::size_t k = 0; k < 16; ++k) changes += on[k] != on[(k + 1) % 16];
  return changes / 2;
}

/// The vertex value from the definition, in degrees.
bool value_by_definition(const Directions& d, const VertexConfig& config) {
  constexpr double kSectorDeg = 180.0 / kDirections;
  const auto ring = ring_by_definition();
  const auto counts = [&](std::size_t k) {
    const auto [x, y] = ring[k % 16];
    if (d.at(x, y) == 0) return false;
    const double contour = (d.at(x, y) % kDirections + 0.5) * kSectorDeg + 90;
    const double radius = std::atan2(y - 2, x - 2) * 180 / M_PI;
    return std::abs(std::remainder(contour - radius, 180.0)) <= 6.25 * kSectorDeg;
  };
  struct Branch {
    int sector, strength;
  };
  std::vector<Branch> branches;
  for (std::size_t k = 0; k < 16; ++k) {
    if (!counts(k) || counts(k + 15)) continue;
    const auto [x, y] = ring[k];
    const bool touches = inner_near(d, x, y, 1);
    branches.push_back({d.at(x, y) % kDirections, touches ? d.at(x, y) / kDirections : 1});
  }
  if (branches.size() < 2 || !inner_near(d, 2, 2, 1)) return false;
  const auto turns = [&](const Branch& a, const Branch& b) {
    const double turn = std::abs(std::remainder(a.sector - b.sector, 1.0 * kDirections));
    const int weaker = std::min(a.strength, b.strength);
    return turn >= config.min_turn + (weaker == 1 ? 5 : weaker == 2 ? 2 : 0);
  };
  return turns(branches[0], branches[1]) || turns(branches[0], branches.back());
}

TEST_CASE("every ring with every set of inner pixels has the branches of the definition") {
  // All 2^24 windows: a ring pixel touches when it is on and beside an inner one, whatever else is
  // on, so each inner set with the whole ring and each ring with all inner pixels say everything.
  constexpr RingOffset kInner[8] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                    {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  constexpr Direction kStrong = 3 << kDirectionBits;
  const auto window = [&](unsigned inner, unsigned ring) {
    Directions d(5, 5);
    for (unsigned i = 0; i < 8; ++i) {
      if (inner >> i & 1) d.at(2 + kInner[i].x, 2 + kInner[i].y) = kStrong;
    }
    for (unsigned k = 0; k < kRingPx; ++k) {
      if (ring >> k & 1) d.at(2 + kRing[k].x, 2 + kRing[k].y) = kStrong;
    }
    return d;
  };
  constexpr unsigned kAll = (1U << kRingPx) - 1;
  std::mt19937 random(41);
  for (unsigned inner = 0; inner < 256; ++inner) {
    const Directions whole = window(inner, kAll);
    const unsigned touched = window_branches(whole, 2, 2).touching;
    REQUIRE(__builtin_popcount(run_starts(touched)) == branches_by_definition(whole));
    for (int round = 0; round < 20; ++round) {
      const unsigned ring = random() & kAll;
      const WindowBranches got = window_branches(window(inner, ring), 2, 2);
      REQUIRE(got.ring == ring);
      REQUIRE(got.touching == (ring & touched));
      REQUIRE(got.inner == (inner != 0));
    }
  }
  for (unsigned ring = 0; ring <= kAll; ++ring) {
    const Directions d = window(255, ring);
    REQUIRE(window_branches(d, 2, 2).touching == ring);
    REQUIRE(__builtin_popcount(run_starts(ring)) == branches_by_definition(d));
  }
}

TEST_CASE("the value of random windows is that of the definition") {
  std::mt19937 random(43);
  int ones = 0;
  for (int round = 0; round < 40000; ++round) {
    Directions d(5, 5);
    const auto share = static_cast<unsigned>(2 + random() % 6);
    for (auto& sample : d.samples) {
      sample = random() % share == 0 ? static_cast<Direction>(32 + random() % 96) : Direction{0};
    }
    VertexConfig config;
    config.min_turn = 1 + static_cast<int>(random() % 16);
    const bool expected = value_by_definition(d, config);
    ones += expected ? 1 : 0;
    REQUIRE(vertex_value(d, 2, 2, config) == expected);
  }
  CHECK(ones > 1000);
}

TEST_CASE("the ring of random windows has the branches of the definition") {
  std::mt19937 random(29);
  for (int round = 0; round < 20000; ++round) {
    Directions d(5, 5);
    for (auto& sample : d.samples) {
      sample = random() % 3 == 0 ? static_cast<Direction>(32 + random() % 96) : Direction{0};
    }
    const unsigned starts = run_starts(window_branches(d, 2, 2).touching);
    int branches = 0;
    for (unsigned rest = starts; rest != 0; rest &= rest - 1) ++branches;
    REQUIRE(branches == branches_by_definition(d));
  }
}

}  // namespace
}  // namespace trihedron::golden
