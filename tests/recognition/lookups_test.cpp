// SPDX-License-Identifier: Apache-2.0
// What is looked up fast, against the same found the plain way.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "recognition/direction_map.hpp"
#include "recognition/edgels.hpp"
#include "recognition/glance.hpp"
#include "recognition/rigs.hpp"
#include "recognition/segment_grid.hpp"
#include "recognition/smooth_rows.hpp"
#include "recognition/view_lanes.hpp"

using namespace trihedron;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// A gradient of any values in the hardware's range.
ViewFeatures random_features(int width, int height, std::mt19937& random) {
  std::uniform_int_distribution<int> slope(-767, 767);
  ViewFeatures f;
  f.width = width;
  f.height = height;
  f.contour.resize(static_cast<std::size_t>(width * height));
  for (ContourBeat& beat : f.contour) {
    beat.gx = static_cast<std::int16_t>(slope(random));
    beat.gy = static_cast<std::int16_t>(slope(random));
  }
  return f;
}

double smooth(const ViewFeatures& f, int x, int y, std::int16_t ContourBeat::*component) {
  if (x == 0 || y == 0 || x == f.width - 1 || y == f.height - 1) return 0;
  const double taps[3] = {0.25, 0.5, 0.25};
  double sum = 0;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i)
      sum += taps[j + 1] * taps[i + 1] * (f.at(x + i, y + j).*component);
  }
  return sum;
}

std::vector<Segment> random_segments(int count, double size_px, std::mt19937& random) {
  std::uniform_real_distribution<double> at(0, size_px);
  std::vector<Segment> out;
  for (int i = 0; i < count; ++i) {
    Segment s;
    s.p0 = {at(random), at(random)};
    s.p1 = {at(random), at(random)};
    s.length = (s.p1 - s.p0).norm();
    s.direction = (s.p1 - s.p0) / s.length;
    s.normal = {-s.direction.y(), s.direction.x()};
    out.push_back(s);
  }
  return out;
}

constexpr double kReachPx = 3, kMaxSine = 0.12;

/// The segment that SegmentGrid::find promises, by trying all.
int find_among_all(const std::vector<Segment>& segments, const Vector2d& p, const Vector2d& d) {
  int found = SegmentGrid::kMiss;
  double best = kReachPx;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    if (std::abs(s.normal.dot(d)) > kMaxSine || std::abs(s.distance(p)) >= best) continue;
    if (s.along(p) < -kReachPx || s.along(p) > s.length + kReachPx) continue;
    best = std::abs(s.distance(p));
    found = static_cast<int>(i);
  }
  return found;
}

}  // namespace

TEST_CASE("rows smoothed one by one are the binomial of the whole image") {
  std::mt19937 random(11);
  const ViewFeatures f = random_features(37, 23, random);
  SmoothRows rows(f);
  constexpr double kFloat = 1e-3;  // of values up to 1024
  for (int middle = 0; middle < f.height; ++middle) {
    rows.move_to(middle);
    for (int y = std::max(0, middle - 3); y <= std::min(f.height - 1, middle + 3); ++y) {
      for (int x = 0; x < f.width; ++x) {
        const auto i = static_cast<std::size_t>(x);
        const double gx = smooth(f, x, y, &ContourBeat::gx), gy = smooth(f, x, y, &ContourBeat::gy);
        REQUIRE(rows.row(y).gx[i] == Approx(gx).margin(kFloat));
        REQUIRE(rows.row(y).gy[i] == Approx(gy).margin(kFloat));
        REQUIRE(rows.row(y).magnitude[i] == Approx(std::hypot(gx, gy)).margin(kFloat));
      }
    }
  }
}

TEST_CASE("an edge point is found by its pixel, and no other pixel has one") {
  std::mt19937 random(12);
  std::bernoulli_distribution taken(0.3);
  EdgelMap map(200, 9);  // four words a row, the last one partly used
  std::vector<int> expected;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      expected.push_back(taken(random) ? static_cast<int>(map.edgels.size()) : -1);
      if (expected.back() >= 0) map.add(x, y, {});
    }
  }
  REQUIRE(map.edgels.size() > 400);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      REQUIRE(map.at(x, y) == expected[static_cast<std::size_t>(y * map.width + x)]);
    }
  }
}

TEST_CASE("the grid finds the segment that a search through all segments finds") {
  std::mt19937 random(13);
  constexpr int kSize = 200;
  const std::vector<Segment> segments = random_segments(60, kSize, random);
  const SegmentGrid grid(segments, kSize, kSize, kReachPx, kMaxSine);
  std::uniform_real_distribution<double> along(-5, 5), across(-5, 5), turn(-0.2, 0.2);
  std::uniform_real_distribution<double> share(0, 1);
  int hits = 0;
  for (int k = 0; k < 20000; ++k) {
    const Segment& s = segments[static_cast<std::size_t>(k) % segments.size()];
    const Vector2d p =
        s.p0 + (share(random) * s.length + along(random)) * s.direction + across(random) * s.normal;
    if (p.minCoeff() < 0 || p.maxCoeff() >= kSize) continue;
    const Vector2d d = Eigen::Rotation2Dd(turn(random)) * (k % 2 ? s.direction : -s.direction);
    const int found = grid.find(static_cast<float>(p.x()), static_cast<float>(p.y()),
                                static_cast<float>(d.x()), static_cast<float>(d.y()));
    const int expected = find_among_all(segments, p, d);
    INFO("point " << p.transpose() << " direction " << d.transpose());
    REQUIRE(found == expected);
    hits += found >= 0;
  }
  REQUIRE(hits > 3000);
  REQUIRE(grid.find(-1, 5, 1, 0) == SegmentGrid::kOutside);
  REQUIRE(grid.find(5, kSize + 8, 1, 0) == SegmentGrid::kOutside);
}

TEST_CASE("the direction map says yes wherever the grid finds a segment, and no at most places") {
  std::mt19937 random(14);
  constexpr int kSize = 203;  // the last cells lie partly outside
  const std::vector<Segment> segments = random_segments(25, kSize, random);
  const SegmentGrid grid(segments, kSize, kSize, kReachPx, kMaxSine);
  const DirectionMap map(segments, kSize, kSize, kReachPx, kMaxSine);
  std::uniform_real_distribution<float> at(0, kSize), angle(0, 6.3F);
  int found = 0, yes = 0;
  constexpr int kCount = 100000;
  for (int k = 0; k < kCount; ++k) {
    const float x = at(random), y = at(random), turn = angle(random);
    const float dx = std::cos(turn), dy = std::sin(turn);
    REQUIRE(map.covers(x, y));
    const bool hit = map.at(x, y) >> DirectionBins::bin(dx, dy) & 1;
    const int segment = grid.find(x, y, dx, dy);
    INFO("point " << x << ' ' << y << " direction " << dx << ' ' << dy);
    if (segment >= 0) REQUIRE(hit);
    found += segment >= 0;
    yes += hit;
  }
  REQUIRE(found > kCount / 100);
  CHECK(yes < 3 * found);  // a cell is 4 px wide where the tolerance is 3 px to either side
}

TEST_CASE("views in lanes see a model as each view does") {
  const std::vector<Camera> cameras = rigs::three_views(GENERATE(true, false));
  std::vector<ViewLines> views;
  for (int k = 0; k < 2; ++k) {  // more views than lanes
    for (const Camera& c : cameras) views.push_back({IdealView(c), 0, 0, {}, {}, {}, {}});
  }
  const Transform pose{Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                       {20, -10, 30}};
  constexpr double kFloatPx = 1e-3;
  for (std::size_t first = 0; first < views.size(); first += LaneRig::kLanes) {
    const LaneRig rig(views, first);
    const ViewLanes lanes(rig, pose);
    REQUIRE(lanes.count() == std::min<std::size_t>(LaneRig::kLanes, views.size() - first));
    for (const Vector3d& x : {Vector3d(0, 0, 0), Vector3d(40, 10, -5), Vector3d(-12, 33, 21)}) {
      const auto images = lanes.project(x.cast<float>());
      const Vector3d normal = x.norm() > 0 ? Vector3d(x.normalized()) : Vector3d(0, 0, 1);
      const auto facing = lanes.facing(normal.cast<float>(), static_cast<float>(normal.dot(x)));
      for (std::size_t lane = 0; lane < lanes.count(); ++lane) {
        const IdealView& view = views[first + lane].ideal;
        const Vector2d expected = view.project(pose * x);
        const std::size_t i = lane;
        REQUIRE(images.x[i] == Approx(expected.x()).margin(kFloatPx));
        REQUIRE(images.y[i] == Approx(expected.y()).margin(kFloatPx));
        REQUIRE((facing[i] > 0) == ((pose.R * normal).dot(view.sight(pose * x)) < 0));
      }
    }
  }
}

TEST_CASE("points that a known object hides, or whose contour is its own, say nothing") {
  const Model block = rigs::block(60, 50, 40), bracket = rigs::l_bracket();
  const Transform front = rigs::pose({0, 0, 0.3}, {10, -45, 21});
  const Transform behind = rigs::pose({0, 0, 0.9}, {-5, 35, 21});
  const std::vector<View> scene = rigs::views_of({{&block, front}, {&bracket, behind}});
  std::vector<ContourField> fields;
  fields.reserve(scene.size());
  std::vector<FieldView> views;
  std::vector<SpreadMap> all;
  for (const View& view : scene) {
    fields.emplace_back(view.features);
    views.push_back({&view.camera, &fields.back()});
    all.push_back(spread_map(fields.back()));
  }
  const Remainder rest = remainder(views, {{&block, front}});
  const auto hidden = glance_points(views, bracket, behind),
             own = glance_points(views, block, front);
  // The bracket loses no evidence by the block in front of it; the block's own is used up.
  CHECK(GlanceScorer(all, rest).score(hidden) > GlanceScorer(rest.maps).score(hidden));
  CHECK(GlanceScorer(all).score(own) > 0);
  CHECK(GlanceScorer(all, rest).score(own) < 0.1 * GlanceScorer(all).score(own));
}
