// SPDX-License-Identifier: Apache-2.0
#include "recognition/surfaces.hpp"

#include <catch2/catch.hpp>

#include "golden/error.hpp"
#include "recognition/crossing_error.hpp"
#include "recognition/paper_scenes.hpp"
#include "recognition/surface_visibility.hpp"

using namespace trihedron;
using namespace trihedron::paper_scenes;
using Eigen::Vector3d;

namespace {

constexpr double kError = 0.5;      // mm, one pixel
constexpr double kRounding = 1e-6;  // mm, doubles through projection and back

CrossingResult crossed(const std::array<std::vector<Region>, 3>& regions, bool pinhole = false) {
  return cross_views(planar_views(exact_views(pinhole)), regions, kError);
}

/// Distance of a surface's vertices from the nearest surface of the placed model: the largest
/// distance of a vertex to its nearest counterpart, smallest over the surfaces.
double distance_to_model(const CrossedSurface& surface, const Model& model, const Transform& pose) {
  double best = 1e9;
  for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
    const SpacePolygon truth = surface_loops(model, static_cast<int>(i))[0];
    if (truth.size() != surface.loops[0].size()) continue;
    double largest = 0;
    for (const Vector3d& v : surface.loops[0]) {
      double nearest = 1e9;
      for (const Vector3d& t : truth) nearest = std::min(nearest, (pose * t - v).norm());
      largest = std::max(largest, nearest);
    }
    best = std::min(best, largest);
  }
  return best;
}

CrossedSurface flat_surface(ViewRole role, double area, int edges) {
  CrossedSurface s;
  s.role = role;
  s.attributes.area = area;
  s.attributes.perimeter = 100;
  s.attributes.normal = Vector3d::UnitZ();
  s.attributes.centroid = {100, 0, 0};
  s.attributes.edge_lengths.assign(static_cast<std::size_t>(edges), 25);
  return s;
}

std::size_t kept(const CrossedSurface& first, const CrossedSurface& second) {
  return without_duplicates({first, second}, Vector3d::Zero()).size();
}

}  // namespace

TEST_CASE("exact views of a box give its five visible faces exactly") {
  const Model box = rigs::block(60, 50, 40);
  const Transform pose = standing(25, 40);
  const CrossingResult result = crossed(regions_of(exact_views(), box, pose));
  CHECK(result.incomplete + result.not_planar + result.contradicted == 0);
  REQUIRE(result.surfaces.size() == 5);
  for (const CrossedSurface& s : result.surfaces) {
    CHECK(distance_to_model(s, box, pose) < kRounding);
    const double towards = s.attributes.normal.dot(
        planar_views(exact_views())[static_cast<std::size_t>(s.role)].towards);
    CHECK(towards > 0);
  }
  const double top_area = result.surfaces[0].attributes.area;
  CHECK(top_area == Approx(60 * 50));
}

TEST_CASE("the face that side and front both see is described once, from the side") {
  const Model box = rigs::block(60, 50, 40);
  const auto surfaces = crossed(regions_of(exact_views(), box, standing(25, 40))).surfaces;
  const auto kept = without_duplicates(surfaces, {-100, -100, 0});
  REQUIRE(kept.size() == 4);
  CHECK(kept[0].role == ViewRole::kTop);
  CHECK(kept[1].role == ViewRole::kSide);
  CHECK(kept[2].role == ViewRole::kSide);
  CHECK(kept[3].role == ViewRole::kFront);
}

TEST_CASE("exact views of an L give its faces exactly") {
  const Model bracket = rigs::l_bracket();
  const Transform pose = standing(200, 40);  // the notch faces away from side and front
  const CrossingResult result = crossed(regions_of(exact_views(), bracket, pose));
  REQUIRE(result.surfaces.size() >= 3);
  CHECK(result.surfaces[0].loops[0].size() == 6);
  for (const CrossedSurface& s : result.surfaces) {
    CHECK(distance_to_model(s, bracket, pose) < kRounding);
  }
}

TEST_CASE("a corner without a partner makes its surface incomplete") {
  const std::vector<Camera> cameras = exact_views();
  auto regions = regions_of(cameras, rigs::block(60, 50, 40), standing(25, 40));
  regions[1].clear();
  regions[2].clear();
  const CrossingResult result = crossed(regions);
  CHECK(result.surfaces.empty());
  CHECK(result.incomplete == 1);
}

TEST_CASE("corners agree up to Error and not beyond") {
  const std::vector<Camera> cameras = exact_views();
  const SpacePolygon top = {{0, 0, 40}, {30, 0, 40}, {0, 20, 40}};
  for (const double shift : {0.9 * kError, 1.1 * kError}) {
    std::array<std::vector<Region>, 3> regions;
    regions[0] = {region_of(cameras[0], top)};
    const SpacePolygon seen = {{shift, 0, 40}, {30 + shift, 0, 40}, {shift, 0, 10}};
    regions[1] = {region_of(cameras[1], seen)};
    CHECK(crossed(regions).surfaces.size() == (shift < kError ? 2 : 0));
  }
}

TEST_CASE("a top corner takes the height that side and front agree on") {
  const std::vector<Camera> cameras = exact_views();
  std::array<std::vector<Region>, 3> regions;
  regions[0] = {region_of(cameras[0], {{0, 0, 0}, {30, 0, 0}, {0, 20, 0}})};
  regions[1] = {region_of(cameras[1], {{0, 0, 40}, {30, 0, 40}, {30, 0, 0}})};
  regions[2] = {region_of(cameras[2], {{0, 0, 40}, {0, 20, 40}, {0, 20, 0}}),
                region_of(cameras[2], {{0, 0, 70}, {0, 9, 70}, {0, 9, 0}})};
  const auto surfaces = crossed(regions).surfaces;
  REQUIRE_FALSE(surfaces.empty());
  for (const Vector3d& v : surfaces[0].loops[0]) CHECK(v.z() == Approx(40));
}

TEST_CASE("without agreement a top corner takes the largest height") {
  const std::vector<Camera> cameras = exact_views();
  std::array<std::vector<Region>, 3> regions;
  regions[0] = {region_of(cameras[0], {{0, 0, 0}, {30, 0, 0}, {0, 20, 0}})};
  regions[1] = {region_of(cameras[1], {{0, 0, 40}, {30, 0, 40}, {30, 0, 10}})};
  const auto surfaces = crossed(regions).surfaces;
  REQUIRE_FALSE(surfaces.empty());
  for (const Vector3d& v : surfaces[0].loops[0]) CHECK(v.z() == Approx(40));
}

TEST_CASE("side corners take the point nearest to their camera, wherever it stands") {
  for (const double side : {-1.0, 1.0}) {
    std::vector<Camera> cameras = exact_views();
    cameras[1] = rigs::look_at({0, side * 600, 30}, {0, 0, 30}, Vector3d::UnitZ(), false);
    std::array<std::vector<Region>, 3> regions;
    regions[0] = {region_of(cameras[0], {{0, -20, 0}, {30, -20, 0}, {30, 20, 0}, {0, 20, 0}})};
    regions[1] = {region_of(cameras[1], {{0, 0, 0}, {30, 0, 0}, {30, 0, 40}})};
    const CrossingResult result = cross_views(planar_views(cameras), regions, kError);
    const auto from_side =
        std::find_if(result.surfaces.begin(), result.surfaces.end(),
                     [](const CrossedSurface& s) { return s.role == ViewRole::kSide; });
    REQUIRE(from_side != result.surfaces.end());
    for (const Vector3d& v : from_side->loops[0]) CHECK(v.y() == Approx(20 * side));
  }
}

TEST_CASE("two faces taken for one region are contradicted by the corner between them") {
  const std::vector<Camera> cameras = exact_views();
  auto regions = regions_of(cameras, rigs::block(60, 50, 40), standing(25, 40));
  REQUIRE(regions[1].size() == 2);
  REQUIRE(crossed(regions).contradicted == 0);
  // the side view's outline as one region, and no contour between the two faces
  double left = 1e9, right = -1e9, high = 1e9, low = -1e9;
  for (const Region& r : regions[1]) {
    for (const Eigen::Vector2d& p : r.outer) {
      left = std::min(left, p.x()), right = std::max(right, p.x());
      high = std::min(high, p.y()), low = std::max(low, p.y());
    }
  }
  Region whole;
  whole.outer = {{left, high}, {left, low}, {right, low}, {right, high}};
  regions[1] = {whole};
  CHECK(crossed(regions).contradicted == 1);
}

TEST_CASE("a region that an unfinished contour divides describes no surface") {
  auto regions = regions_of(exact_views(), rigs::block(60, 50, 40), standing(25, 40));
  regions[0][0].loose_px = 20;
  const CrossingResult result = crossed(regions);
  CHECK(result.in_pieces == 1);
  CHECK(result.surfaces.size() == 4);
}

TEST_CASE("duplicates agree within 20 percent in every attribute") {
  const CrossedSurface top = flat_surface(ViewRole::kTop, 1000, 4);
  const auto front = [](double area, int edges) {
    return flat_surface(ViewRole::kFront, area, edges);
  };
  CHECK(kept(top, front(1000, 4)) == 1);
  CHECK(kept(top, front(1240, 4)) == 1);  // differs by 0.194 of its own area
  CHECK(kept(top, front(1260, 4)) == 2);  // 0.206
  CHECK(kept(top, front(1000, 5)) == 1);  // exactly 0.20
  CHECK(kept(top, front(1000, 6)) == 2);

  CrossedSurface other = front(1000, 4);
  other.attributes.perimeter = 126;
  CHECK(kept(top, other) == 2);

  other = front(1000, 4);
  other.attributes.normal = Eigen::AngleAxisd(0.19, Vector3d::UnitX()) * Vector3d::UnitZ();
  CHECK(kept(top, other) == 1);
  other.attributes.normal = Eigen::AngleAxisd(0.21, Vector3d::UnitX()) * Vector3d::UnitZ();
  CHECK(kept(top, other) == 2);

  other = front(1000, 4);
  other.attributes.centroid = {100, 19, 0};
  CHECK(kept(top, other) == 1);
  other.attributes.centroid = {100, 21, 0};
  CHECK(kept(top, other) == 2);
}

TEST_CASE("surfaces of one view are no duplicates of each other") {
  const CrossedSurface top = flat_surface(ViewRole::kTop, 1000, 4);
  CHECK(kept(top, top) == 2);
  const CrossedSurface side = flat_surface(ViewRole::kSide, 1000, 4);
  CHECK(kept(side, side) == 2);
}

TEST_CASE("Error is a pixel of both views together, or half the smallest edge gap") {
  const auto views = planar_views(exact_views());
  CHECK(crossing_error_mm(views, {rigs::block(60, 50, 40)}) == Approx(1 / kPxPerMm));
  CHECK(smallest_edge_gap_mm(rigs::block(60, 50, 0.5)) == Approx(0.5));
  CHECK(crossing_error_mm(views, {rigs::block(60, 50, 0.5)}) == Approx(0.25));
}

TEST_CASE("views are told apart by where they look; one of each is needed") {
  std::vector<Camera> cameras = exact_views();
  std::swap(cameras[0], cameras[2]);
  const auto views = planar_views(cameras);
  CHECK(views[0].view == 2);
  CHECK(views[2].view == 0);
  CHECK((views[0].towards - Vector3d::UnitZ()).norm() < 1e-12);
  cameras[0] = cameras[2];
  REQUIRE_THROWS_WITH(planar_views(cameras), Catch::Contains("2 top"));
  CHECK_THROWS_AS(planar_views(cameras), Error);
}

TEST_CASE("a perspective view is scaled as at the table's middle") {
  const auto views = planar_views(exact_views(true));
  const Camera& top = views[0].camera;
  const Vector3d on_table(30, -20, 0), above(30, -20, 60);
  CHECK((views[0].measure(top.project(on_table)) - on_table).norm() < kRounding);
  // 60 of 630 mm nearer: larger by 630 / 570
  CHECK(views[0].measure(top.project(above)).x() == Approx(30 * 630.0 / 570));
}
