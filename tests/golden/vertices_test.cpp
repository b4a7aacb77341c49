// SPDX-License-Identifier: Apache-2.0
#include "golden/vertices.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "golden/front_end.hpp"
#include "images.hpp"

namespace trihedron::golden {
namespace {

using Directions = Plane<Direction>;

constexpr Direction kStrong = 3 << 6;

/// A 5x5 window from its rows; '.' is no branch, a letter a strong branch pixel of its direction.
Directions window(const std::vector<std::string>& rows, int sector_of_a, int sector_of_b) {
  Directions d(5, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      if (c != '.')
        d.at(x, y) = static_cast<Direction>(kStrong | (c == 'a' ? sector_of_a : sector_of_b));
    }
  }
  return d;
}

TEST_CASE("the sector is the gradient's angle in 1/64 turns") {
  // A threshold rounded to 1/64 of the tangent moves a sector's border by up to half a degree.
  constexpr double kBorderDeg = 0.5;
  std::mt19937 random(3);
  for (int round = 0; round < 20000; ++round) {
    const int gx = static_cast<int>(random() % 1531) - 765;
    const int gy = static_cast<int>(random() % 1531) - 765;
    if (gx == 0 && gy == 0) continue;
    const double angle = std::atan2(gy, gx) * 180 / M_PI;
    const double centre = (direction_sector(gx, gy) + 0.5) * 360 / kDirections;
    const double off = std::remainder(angle - centre, 360.0);
    INFO(gx << ", " << gy);
    REQUIRE(std::abs(off) <= 180.0 / kDirections + kBorderDeg);
    REQUIRE((direction_sector(-gy, gx) - direction_sector(gx, gy) + 64) % 64 == 16);
  }
  CHECK(direction_sector(0, 0) == 7);
}

TEST_CASE("the class of a magnitude changes at 1, 3/2 and 5/2 of the floor") {
  for (const auto& [magnitude, expected] :
       {std::pair{0, 0}, {19, 0}, {20, 1}, {29, 1}, {30, 2}, {49, 2}, {50, 3}, {511, 3}}) {
    CHECK(magnitude_class(magnitude, 20) == expected);
  }
}

TEST_CASE("a straight contour is no vertex, a corner is worth its turn and its bend") {
  const std::vector<std::string> straight{".....", ".....", "aaaaa", ".....", "....."};
  CHECK(vertex_value(window(straight, 16, 16), 2, 2, {}).strength == 0);
  const std::vector<std::string> corner{".....", ".....", "..aaa", "..b..", "..b.."};
  const VertexValue value = vertex_value(window(corner, 48, 32), 2, 2, {});
  CHECK(value.strength == 16 + 4);  // a quarter turn; branches 0 and 4 of 16, 4 short of opposite
  CHECK(value.branches == 2);
  CHECK(value.pattern == 16 * 0 + 4);
}

TEST_CASE("weak branches must turn further") {
  const std::vector<std::string> corner{".....", ".....", "..aaa", "..b..", "..b.."};
  for (const auto& [strength, least] : {std::pair{3, 5}, {2, 7}, {1, 10}}) {
    for (const int turn : {least - 1, least}) {
      Directions d = window(corner, 0, 64 - turn);
      d.at(2, 4) = static_cast<Direction>(strength << 6 | (64 - turn));
      INFO("class " << strength << " turn " << turn);
      CHECK(vertex_value(d, 2, 2, {}).strength == (turn == least ? turn + 4 : 0));
    }
  }
}

TEST_CASE("three and more branches are junctions, best where they meet") {
  const std::vector<std::string> tee{".....", ".....", "aaaaa", "..b..", "..b.."};
  const VertexValue t = vertex_value(window(tee, 16, 32), 2, 2, {});
  CHECK(t.branches == 3);
  CHECK(t.strength == 96 + 32 - 2 * 2);  // positions (2,0) (0,2) (-2,0)
  CHECK(t.pattern == 16 * 0 + 8);
  const std::vector<std::string> beside{".....", ".....", "aaaaa", "...b.", "...b."};
  CHECK(vertex_value(window(beside, 16, 32), 2, 2, {}).strength < t.strength);
  const std::vector<std::string> cross{"b...a", ".b.a.", "..a..", ".a.b.", "a...b"};
  CHECK(vertex_value(window(cross, 8, 40), 2, 2, {}).branches == 4);
  CHECK(vertex_value(window(cross, 8, 40), 2, 2, {}).strength == 128);
}

TEST_CASE("a contour that passes by without touching is no branch") {
  const std::vector<std::string> corner{"bbbbb", ".....", "aaaaa", ".....", "....."};
  CHECK(vertex_value(window(corner, 16, 40), 2, 2, {}).strength == 0);
}

/// Branches from the definition: outer pixels that touch an inner one, flooded along the ring.
int branches_by_definition(const Directions& d) {
  std::vector<std::pair<int, int>> ring;
  for (int i = 0; i < 5; ++i) ring.emplace_back(4, i);
  for (int i = 3; i >= 0; --i) ring.emplace_back(i, 4);
  for (int i = 3; i >= 0; --i) ring.emplace_back(0, i);
  for (int i = 1; i < 4; ++i) ring.emplace_back(i, 0);
  std::vector<bool> on;
  for (const auto& [x, y] : ring) {
    bool touches = false;
    for (int v = 1; v < 4; ++v) {
      for (int u = 1; u < 4; ++u) {
        const bool inner = (u != 2 || v != 2) && d.at(u, v) != 0;
        touches = touches || (inner && std::abs(u - x) <= 1 && std::abs(v - y) <= 1);
      }
    }
    on.push_back(touches && d.at(x, y) != 0);
  }
  int changes = 0;
  for (std::size_t k = 0; k < 16; ++k) changes += on[k] != on[(k + 1) % 16];
  return changes / 2;
}

TEST_CASE("random windows have the branches of the definition and values in range") {
  std::mt19937 random(29);
  for (int round = 0; round < 20000; ++round) {
    Directions d(5, 5);
    for (auto& sample : d.samples) {
      const bool on = random() % 3 == 0;
      sample = on ? static_cast<Direction>(64 + random() % 192) : Direction{0};
    }
    const VertexValue value = vertex_value(d, 2, 2, {});
    const int branches = branches_by_definition(d);
    if (value.strength == 0) REQUIRE(branches <= 2);
    if (branches >= 3) REQUIRE(value.strength >= 48);
    if (value.strength != 0) REQUIRE(value.branches == branches);
    if (branches == 2) REQUIRE(value.strength <= 40);
    REQUIRE(value.strength <= 128);
  }
}

TEST_CASE("an image turned by a half has its vertices turned, within one pixel") {
  // Ties of magnitude and of value go to the first in raster order: one pixel when turned.
  constexpr int kTiePx = 1;
  test::Image image(40, 36);
  std::fill(image.samples.begin(), image.samples.end(), std::uint8_t{50});
  for (int y = 10; y < 26; ++y) {
    for (int x = 12; x < 30; ++x) image.at(x, y) = 150;
  }
  const ViewFeatures f = run_front_end(image.samples.data(), 40, 36, 40);
  REQUIRE(f.vertices.size() == 4);
  const int corners[4][2] = {{12, 10}, {29, 10}, {12, 25}, {29, 25}};
  for (const auto& corner : corners) {
    CHECK(std::any_of(f.vertices.begin(), f.vertices.end(), [&](const Vertex& v) {
      return std::abs(v.x - corner[0]) <= kTiePx && std::abs(v.y - corner[1]) <= kTiePx &&
             v.branches == 2;
    }));
  }
  std::reverse(image.samples.begin(), image.samples.end());
  const ViewFeatures turned = run_front_end(image.samples.data(), 40, 36, 40);
  REQUIRE(turned.vertices.size() == 4);
  for (const Vertex& v : turned.vertices) {
    CHECK(std::any_of(f.vertices.begin(), f.vertices.end(), [&](const Vertex& u) {
      return std::abs(39 - v.x - u.x) <= kTiePx && std::abs(35 - v.y - u.y) <= kTiePx;
    }));
  }
}

TEST_CASE("no two vertices share a 5x5 window and all lie on the contour") {
  const test::Image image = test::noise(120, 90, 41);
  const ViewFeatures f = run_front_end(image.samples.data(), 120, 90, 120);
  REQUIRE(f.vertices.size() > 20);
  for (const Vertex& v : f.vertices) {
    CHECK(f.at(v.x, v.y).contour());
    for (const Vertex& u : f.vertices) {
      if (&u != &v) CHECK((std::abs(u.x - v.x) > 2 || std::abs(u.y - v.y) > 2));
    }
  }
  CHECK(std::is_sorted(f.vertices.begin(), f.vertices.end(), [](const Vertex& a, const Vertex& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  }));
}

}  // namespace
}  // namespace trihedron::golden
