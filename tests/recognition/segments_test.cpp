// SPDX-License-Identifier: Apache-2.0
#include "recognition/segments.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "recognition/corners.hpp"
#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector2d;

namespace {

constexpr int kSize = 120;
constexpr double kCornerPx = 0.15;  // quantised grey levels and masks that round corners

Camera camera() {
  Camera c;
  c.K << 1000, 0, 60, 0, 1000, 60, 0, 0, 1;
  c.width_px = c.height_px = kSize;
  return c;
}

/// A bright convex polygon on a dark ground, 64 samples a pixel, with Gaussian noise.
ViewFeatures polygon_features(const std::vector<Vector2d>& polygon, double noise) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss(0, 1);
  std::vector<std::uint8_t> grey;
  const auto inside = [&](const Vector2d& p) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2d a = polygon[i], d = polygon[(i + 1) % polygon.size()] - a;
      if (d.x() * (p - a).y() - d.y() * (p - a).x() < 0) return false;
    }
    return true;
  };
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      int hits = 0;
      for (int k = 0; k < 64; ++k) {
        hits += inside({x - 0.5 + (k % 8 + 0.5) / 8, y - 0.5 + (k / 8 + 0.5) / 8}) ? 1 : 0;
      }
      const double value = 60 + 80.0 * hits / 64 + noise * gauss(random);
      grey.push_back(static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)));
    }
  }
  return golden::run_front_end(grey.data(), kSize, kSize, kSize);
}

const std::vector<Vector2d> kQuad = {{20.3, 25.8}, {95.1, 18.4}, {88.7, 99.2}, {31.6, 80.5}};

}  // namespace

TEST_CASE("a polygon gives one segment a side and its corners") {
  const double noise = GENERATE(0.0, 3.0);
  const auto segments = find_segments(find_edgels(polygon_features(kQuad, noise)), camera());
  INFO("noise " << noise);
  REQUIRE(segments.size() >= 4);
  // The four sides come first: longest first, chance segments are short.
  for (std::size_t i = 0; i < 4; ++i) CHECK(segments[i].length > 50);
  for (std::size_t i = 4; i < segments.size(); ++i) CHECK(segments[i].length < 20);
  const auto corners = find_corners(segments);
  for (const Vector2d& p : kQuad) {
    double nearest = 1e9;
    for (const Corner& c : corners) nearest = std::min(nearest, (c.p - p).norm());
    CHECK(nearest < kCornerPx + 0.1 * noise);
  }
}

TEST_CASE("a segment's normal points to the bright side") {
  const auto segments = find_segments(find_edgels(polygon_features(kQuad, 0)), camera());
  REQUIRE(segments.size() == 4);
  for (const Segment& s : segments) CHECK(s.distance({58, 56}) > 0);
}

TEST_CASE("noise alone gives no long segment") {
  const auto segments =
      find_segments(find_edgels(polygon_features({{0, 0}, {-1, 0}}, 4)), camera());
  for (const Segment& s : segments) CHECK(s.length < 20);
}

TEST_CASE("lens distortion is taken out of segments") {
  Camera bent = camera();
  bent.distortion = {-2.0, 0, 0, 0, 0};  // about 1 px at the image's corners
  const auto plain = find_segments(find_edgels(polygon_features(kQuad, 0)), camera());
  const auto straight = find_segments(find_edgels(polygon_features(kQuad, 0)), bent);
  REQUIRE(straight.size() == plain.size());
  CHECK((straight[0].middle() - bent.undistort(plain[0].middle())).norm() < 0.3);
  CHECK((straight[0].p0 - plain[0].p0).norm() > 0.2);
}
