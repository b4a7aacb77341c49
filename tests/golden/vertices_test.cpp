// SPDX-License-Identifier: Apache-2.0
#include "golden/vertices.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "golden/front_end.hpp"
#include "golden/vertex_ring.hpp"
#include "images.hpp"

namespace trihedron::golden {
namespace {

using Directions = Plane<Direction>;

constexpr Direction kStrong = 3 << kDirectionBits;

/// A plane from its rows; '.' is no branch, a letter a strong branch pixel of its direction.
Directions plane(const std::vector<std::string>& rows, int sector_of_a, int sector_of_b) {
  Directions d(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < d.height; ++y) {
    for (int x = 0; x < d.width; ++x) {
      const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      if (c != '.') {
        d.at(x, y) = static_cast<Direction>(kStrong | (c == 'a' ? sector_of_a : sector_of_b));
      }
    }
  }
  return d;
}

bool value(const std::vector<std::string>& rows, int sector_of_a, int sector_of_b) {
  return vertex_value(plane(rows, sector_of_a, sector_of_b), 2, 2, {});
}

// Sectors of contours that run along the axes: a horizontal one has a vertical gradient.
constexpr int kHorizontal = 16;
constexpr int kVertical = 0;

TEST_CASE("the sector is the direction of the gradient in 1/64 turns, modulo a half") {
  // A threshold rounded to 1/64 of the tangent moves a sector's border by up to half a degree.
  constexpr double kBorderDeg = 0.5;
  std::mt19937 random(3);
  for (int round = 0; round < 20000; ++round) {
    const int gx = static_cast<int>(random() % 1531) - 765;
    const int gy = static_cast<int>(random() % 1531) - 765;
    if (gx == 0 && gy == 0) continue;
    const double angle = std::atan2(gy, gx) * 180 / M_PI;
    const double centre = (direction_sector(gx, gy) + 0.5) * 180 / kDirections;
    const double off = std::remainder(angle - centre, 180.0);
    INFO(gx << ", " << gy);
    REQUIRE(std::abs(off) <= 90.0 / kDirections + kBorderDeg);
    REQUIRE((direction_sector(-gy, gx) - direction_sector(gx, gy) + 32) % 32 == 16);
  }
  CHECK(direction_sector(0, 0) == 7);
}

TEST_CASE("the class of a magnitude changes at 1, 3/2 and 5/2 of the floor") {
  for (const auto& [magnitude, expected] :
       {std::pair{0, 0}, {19, 0}, {20, 1}, {29, 1}, {30, 2}, {49, 2}, {50, 3}, {511, 3}}) {
    CHECK(magnitude_class(magnitude, 20) == expected);
  }
}

TEST_CASE("a straight contour is no vertex, a corner is one") {
  CHECK_FALSE(value({".....", ".....", "aaaaa", ".....", "....."}, kHorizontal, kHorizontal));
  CHECK(value({".....", ".....", "..aaa", "..b..", "..b.."}, kHorizontal, kVertical));
}

TEST_CASE("weak branches must turn further") {
  const std::vector<std::string> corner{".....", ".....", "..aaa", "...b.", "....b"};
  for (const auto& [strength, least] : {std::pair{3, 6}, {2, 8}, {1, 11}}) {
    for (const int turn : {least - 1, least}) {
      Directions d = plane(corner, 14, 14 + turn);
      d.at(4, 4) = static_cast<Direction>(strength << kDirectionBits | (14 + turn));
      INFO("class " << strength << " turn " << turn);
      CHECK(vertex_value(d, 2, 2, {}) == (turn == least));
    }
  }
}

TEST_CASE("a branch runs along the radius") {
  // The ring's right pixel: sectors 10 .. 21 pass; the branch below stays and turns from all.
  const std::vector<std::string> corner{".....", ".....", "..aaa", "..b..", "..b.."};
  for (int sector = 0; sector < kDirections; ++sector) {
    const bool turned = turn_between(static_cast<Direction>(sector), kVertical) >= 6;
    INFO("sector " << sector);
    CHECK(value(corner, sector, kVertical) == (sector >= 10 && sector <= 21 && turned));
  }
  // Two contours side by side touch the ring in many places, none of them along the radius.
  CHECK_FALSE(value({"....b", "...b.", "a.b..", ".a...", "..a.."}, 8, 8));
}

TEST_CASE("three branches are a vertex also when two of them are one line") {
  for (const bool stem_below : {true, false}) {
    std::vector<std::string> tee{".....", ".....", "aaaaa", "..b..", "..b.."};
    if (!stem_below) std::reverse(tee.begin(), tee.end());
    CHECK(value(tee, kHorizontal, kVertical));
  }
  CHECK(value({"..b..", "..b..", "..aaa", "..b..", "..b.."}, kHorizontal, kVertical));
  CHECK(value({"..b..", "..b..", "aaa..", "..b..", "..b.."}, kHorizontal, kVertical));
}

TEST_CASE("the centre of a vertex need not be contour") {
  CHECK(value({".....", ".....", "...aa", "..b..", "..b.."}, kHorizontal, kVertical));
}

TEST_CASE("a stem that ends before its crossbar is a branch of class 1") {
  const std::vector<std::string> gap{"..b..", ".....", "aaaaa", ".....", "....."};
  const std::vector<std::string> whole{"..b..", "..b..", "aaaaa", ".....", "....."};
  for (const auto& [stem, turn] : {std::pair{5, 9}, {4, 10}, {3, 11}, {2, 12}}) {
    INFO("turn " << turn);
    CHECK(value(whole, 14, stem));
    CHECK(value(gap, 14, stem) == (turn >= 11));
  }
  CHECK_FALSE(value({"..a..", ".....", "aaaaa", ".....", "....."}, kHorizontal, kVertical));
}

TEST_CASE("branches around an empty middle are no vertex") {
  CHECK_FALSE(value({".....", ".....", "....a", ".....", "..b.."}, kHorizontal, kVertical));
  CHECK(value({".....", ".a...", "....a", ".....", "..b.."}, kHorizontal, kVertical));
}

TEST_CASE("a mirrored or turned window has the same value where each branch is one pixel") {
  // A mirrored run begins at its other end, so runs of one pixel only.
  std::mt19937 random(31);
  int ones = 0;
  for (int round = 0; round < 20000; ++round) {
    Directions d(5, 5);
    for (auto& sample : d.samples) {
      const bool on = random() % 4 == 0;
      sample = on ? static_cast<Direction>(kStrong | random() % kDirections) : Direction{0};
    }
    const unsigned ring = window_branches(d, 2, 2).ring;
    if (run_starts(ring) != ring) continue;
    const auto each = [](Directions in, int from) {
      for (auto& sample : in.samples) {
        if (sample == 0) continue;
        sample = static_cast<Direction>(kStrong | ((from - sample) & (kDirections - 1)));
      }
      return in;
    };
    // Mirrored left to right a direction s becomes 31 - s, rows and columns exchanged 15 - s.
    const bool here = vertex_value(d, 2, 2, {});
    int starts = 0;
    for (unsigned rest = ring; rest != 0; rest &= rest - 1) ++starts;
    if (starts != 2) continue;
    ones += here ? 1 : 0;
    REQUIRE(vertex_value(each(test::mirrored(d), 31), 2, 2, {}) == here);
    REQUIRE(vertex_value(each(test::transposed(d), 15), 2, 2, {}) == here);
  }
  CHECK(ones > 100);
}

TEST_CASE("the score is a quarter of the weighted sum of the values") {
  constexpr int kWeight[5] = {1, 4, 6, 4, 1};
  Plane<std::uint8_t> values(70, 9);
  std::mt19937 random(37);
  for (auto& sample : values.samples) sample = random() % 3 == 0 ? 1 : 0;
  Plane<std::uint16_t> scores(70, 9);
  for (int y = 0; y < 9; ++y) score_row(values, y, scores);
  for (int y = 2; y < 7; ++y) {
    for (int x = 2; x < 68; ++x) {
      int sum = 0;
      for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 5; ++i)
          sum += kWeight[i] * kWeight[j] * values.at(x + i - 2, y + j - 2);
      }
      REQUIRE(scores.at(x, y) == sum / 4);
    }
  }
}

TEST_CASE("three pixels are too few for a vertex, a square of four enough") {
  const Directions none(12, 12);
  for (const bool fourth : {false, true}) {
    Plane<std::uint8_t> values(12, 12);
    values.at(5, 5) = values.at(6, 5) = values.at(5, 6) = 1;
    if (fourth) values.at(6, 6) = 1;
    Plane<std::uint16_t> scores(12, 12);
    for (int y = 0; y < 12; ++y) score_row(values, y, scores);
    std::vector<Vertex> found;
    for (int y = 0; y < 12; ++y) append_vertices(none, scores, y, found);
    REQUIRE(found.size() == (fourth ? 1U : 0U));
    if (fourth) CHECK((found[0].x == 5 && found[0].y == 5 && found[0].strength == kLeastScore));
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

TEST_CASE("vertices keep their distance and come in raster order") {
  const test::Image image = test::noise(120, 90, 41);
  const ViewFeatures f = run_front_end(image.samples.data(), 120, 90, 120);
  REQUIRE(f.vertices.size() > 20);
  for (const Vertex& v : f.vertices) {
    CHECK((v.strength >= kLeastScore && v.strength <= 64));
    CHECK((v.x >= 2 && v.y >= 2 && v.x < 118 && v.y < 88));
    for (const Vertex& u : f.vertices) {
      if (&u != &v) CHECK((std::abs(u.x - v.x) > 2 || std::abs(u.y - v.y) > 1));
    }
  }
  CHECK(std::is_sorted(f.vertices.begin(), f.vertices.end(), [](const Vertex& a, const Vertex& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  }));
}

}  // namespace
}  // namespace trihedron::golden
