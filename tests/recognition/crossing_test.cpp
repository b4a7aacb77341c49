// SPDX-License-Identifier: Apache-2.0
#include "recognition/crossing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "recognition/index.hpp"
#include "recognition/remaining_lines.hpp"
#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

constexpr double kEndMm = 1.2;  // two pixels of 0.49 mm, seen at a slant

std::vector<ViewLines> lines_of(const std::vector<Camera>& cameras, const PlacedModel& placed) {
  std::vector<ViewLines> out;
  for (const Camera& c : cameras) out.push_back(find_lines({c, rigs::features_of(c, {placed})}));
  return out;
}

/// Three views that see every surface they see at more than 20 degrees.
std::vector<Camera> oblique_views(bool pinhole) {
  const Vector3d target(0, 0, 20), up = Vector3d::UnitZ();
  return {rigs::look_at({400, -350, 350}, target, up, pinhole),
          rigs::look_at({-250, -400, 400}, target, up, pinhole),
          rigs::look_at({450, 200, 380}, target, up, pinhole)};
}

/// Whether some whole edge in space joins two points.
bool found(const std::vector<SpaceEdge>& edges, const Vector3d& p, const Vector3d& q) {
  return std::any_of(edges.begin(), edges.end(), [&](const SpaceEdge& e) {
    if (!e.agreed[0] || !e.agreed[1]) return false;
    const double there = std::max((e.end[0] - p).norm(), (e.end[1] - q).norm());
    const double back = std::max((e.end[0] - q).norm(), (e.end[1] - p).norm());
    return std::min(there, back) < kEndMm;
  });
}

}  // namespace

TEST_CASE("most outline edges of two views are found in space") {
  const bool pinhole = GENERATE(true, false);
  const Model model = rigs::block(60, 45, 35);
  const Transform pose = rigs::pose({0, 0, 0.45}, {5, -8, 17.5});
  const auto views = lines_of(oblique_views(pinhole), {&model, pose});
  const std::vector<SpaceEdge> edges = cross_edges(views);
  int visible_twice = 0, crossed = 0;
  for (const ModelEdge& e : model.edges) {
    const Vector3d p = pose * model.mesh.vertices[static_cast<std::size_t>(e.v0)];
    const Vector3d q = pose * model.mesh.vertices[static_cast<std::size_t>(e.v1)];
    int views_that_see = 0;
    for (const ViewLines& v : views) {
      const auto front = [&](int s) {
        return (pose.R * model.surfaces[static_cast<std::size_t>(s)].normal).dot(v.ideal.sight(p)) <
               0;
      };
      const bool long_enough = (v.ideal.project(p) - v.ideal.project(q)).norm() > 30;
      views_that_see += long_enough && front(e.left) != front(e.right) ? 1 : 0;
    }
    if (views_that_see < 2) continue;
    ++visible_twice;
    crossed += found(edges, p, q) ? 1 : 0;
  }
  INFO("pinhole " << pinhole);
  REQUIRE(visible_twice >= 3);
  // Where a third edge meets them at a flat angle, ends drown and are not agreed.
  CHECK(3 * crossed >= 2 * visible_twice);
}

TEST_CASE("an ideal view inverts its own projection") {
  const bool pinhole = GENERATE(true, false);
  for (const Camera& camera : rigs::three_views(pinhole)) {
    const IdealView view(camera);
    const Vector3d x(12, -7, 31), y(-20, 4, 11);
    CHECK((view.project(x) - camera.project(x)).norm() < 1e-9);
    const Ray ray = view.ray(view.project(x));
    CHECK((x - ray.origin).cross(ray.direction).norm() < 1e-9);
    const Plane plane = view.plane(view.project(x), view.project(y));
    CHECK(std::abs(plane.distance(x)) < 1e-9);
    CHECK(std::abs(plane.distance(y)) < 1e-9);
  }
}

TEST_CASE("an edge of which one view hides the far end is whole where the other sees a corner") {
  const Model model = rigs::block(60, 45, 35), screen = rigs::block(50, 6, 60);
  const Transform pose = rigs::pose({0, 0, 0.45}, {5, -8, 17.5});
  // Between the second camera and one end of the block, where the others look past it.
  const Transform before = rigs::pose({0, 0, -0.55}, {-42, -75, 30});
  const std::vector<Camera> cameras = oblique_views(true);
  std::vector<ViewLines> views;
  for (const Camera& c : cameras) {
    const ViewLines all =
        find_lines({c, rigs::features_of(c, {{&model, pose}, {&screen, before}})});
    views.push_back(remaining_lines(all, c, {{&screen, before}}));
  }
  CrossingOptions corners;
  corners.one_view_ends = true;
  const auto both = cross_edges(views), one = cross_edges(views, corners);
  int whole_by_both = 0, whole_by_one = 0;
  for (const ModelEdge& e : model.edges) {
    const Vector3d p = pose * model.mesh.vertices[static_cast<std::size_t>(e.v0)];
    const Vector3d q = pose * model.mesh.vertices[static_cast<std::size_t>(e.v1)];
    whole_by_both += found(both, p, q);
    whole_by_one += found(one, p, q);
  }
  CHECK(whole_by_one > whole_by_both);
}
