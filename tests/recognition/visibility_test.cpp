// SPDX-License-Identifier: Apache-2.0
#include "recognition/visibility.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

/// Where the line from `x` towards the camera meets the objects nearer than `margin` mm before
/// the point itself does: brute force over all triangles.
bool hidden(const Camera& camera, const std::vector<PlacedModel>& objects, const Vector3d& x,
            double margin) {
  const Ray ray = camera.ray(camera.project(x));
  const double distance = ray.direction.dot(x - ray.origin);
  for (const PlacedModel& placed : objects) {
    const Mesh& mesh = placed.model->mesh;
    for (const auto& t : mesh.triangles) {
      const Vector3d a = placed.world_from_model * mesh.vertices[t[0]];
      const Vector3d e1 = placed.world_from_model * mesh.vertices[t[1]] - a;
      const Vector3d e2 = placed.world_from_model * mesh.vertices[t[2]] - a;
      const Vector3d p = ray.direction.cross(e2);
      const double det = e1.dot(p);
      if (std::abs(det) < 1e-9) continue;
      const Vector3d s = ray.origin - a;
      const double u = s.dot(p) / det, v = ray.direction.dot(s.cross(e1)) / det;
      const double d = e2.dot(s.cross(e1)) / det;
      if (u >= 0 && v >= 0 && u + v <= 1 && d < distance - margin) return true;
    }
  }
  return false;
}

int count(const std::vector<VisibleEdge>& edges, EdgeType type) {
  return static_cast<int>(std::count_if(edges.begin(), edges.end(),
                                        [&](const VisibleEdge& e) { return e.type == type; }));
}

}  // namespace

TEST_CASE("a block seen at a slant shows six silhouette edges and three creases") {
  const Model block = rigs::block(60, 50, 40);
  const Camera camera = rigs::look_at({400, -300, 350}, {0, 0, 0}, Vector3d::UnitZ());
  const auto edges = visible_edges(camera, {{&block, {}}});
  CHECK(edges.size() == 9);
  CHECK(count(edges, EdgeType::kSilhouette) == 6);
  CHECK(count(edges, EdgeType::kCrease) == 3);
  for (const VisibleEdge& e : edges) {
    CHECK(e.s0 == 0);
    CHECK(e.s1 == 1);
  }
}

TEST_CASE("an orthographic view along an axis shows one surface and its four edges") {
  const Model block = rigs::block(60, 50, 40);
  const Camera camera = rigs::look_at({0, 0, 500}, {0, 0, 0}, Vector3d::UnitY(), /*pinhole=*/false);
  CHECK(visible_edges(camera, {{&block, {}}}).size() == 4);
}

TEST_CASE("normals point away from the visible surface") {
  const Model block = rigs::block(60, 50, 40);
  const PlacedModel placed{&block, rigs::pose({0.3, 0.2, 0.5}, {5, 3, 30})};
  for (const Camera& camera : rigs::three_views()) {
    for (const VisibleEdge& e : visible_edges(camera, {placed})) {
      const Vector3d inside = placed.world_from_model * block.surfaces[e.surface].centroid;
      CHECK(e.normal.dot(camera.project(inside) - e.x0) < 0);
    }
  }
}

TEST_CASE("hidden lines agree with rays cast at random points of random poses") {
  const Model models[] = {rigs::l_bracket(), rigs::block(60, 50, 40)};
  // Points nearer to the end of a visible piece are left out, mm: there rounding decides.
  constexpr double kMarginMm = 1e-2;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  int seen = 0, unseen = 0;
  for (int round = 0; round < 60; ++round) {
    // The second block stands far off the first, so that they never touch.
    const std::vector<PlacedModel> objects = {
        {&models[0], rigs::pose({3 * u(random), 3 * u(random), 3 * u(random)}, {0, 0, 30})},
        {&models[1], rigs::pose({3 * u(random), 3 * u(random), 3 * u(random)}, {130, -110, 50})}};
    const Camera camera = rigs::look_at({400 + 20 * u(random), -300 + 60 * u(random), 90},
                                        {20, -20, 30}, Vector3d::UnitZ(), round % 2 == 0);
    const auto edges = visible_edges(camera, objects);
    for (int object = 0; object < 2; ++object) {
      const Model& model = *objects[object].model;
      for (int i = 0; i < static_cast<int>(model.edges.size()); ++i) {
        const double s = 0.5 + 0.45 * u(random);
        const Vector3d& v0 = model.mesh.vertices[model.edges[i].v0];
        const Vector3d& v1 = model.mesh.vertices[model.edges[i].v1];
        bool visible = false, near_end = false;
        for (const VisibleEdge& e : edges) {
          if (e.object != object || e.edge != i) continue;
          visible |= s >= e.s0 && s <= e.s1;
          const double to_end = std::min(std::abs(s - e.s0), std::abs(s - e.s1));
          near_end |= to_end * model.edges[i].length < kMarginMm;
        }
        if (near_end) continue;
        const Vector3d x = objects[object].world_from_model * (v0 + s * (v1 - v0));
        INFO("round " << round << " object " << object << " edge " << i << " at " << s);
        CHECK(visible == !hidden(camera, objects, x, kMarginMm));
        (visible ? seen : unseen)++;
      }
    }
  }
  CHECK(seen > 300);
  CHECK(unseen > 300);
}

TEST_CASE("an object before another hides its surfaces and edges") {
  const Model block = rigs::block(40, 40, 40);
  const Camera camera = rigs::look_at({0, -600, 20}, {0, 0, 20}, Vector3d::UnitZ());
  const std::vector<PlacedModel> objects = {{&block, rigs::pose({0, 0, 0}, {0, 60, 20})},
                                            {&block, rigs::pose({0, 0, 0}, {20, -60, 20})}};
  const auto alone = surface_visibility(camera, {objects[0]}, 0);
  const auto behind = surface_visibility(camera, objects, 0);
  int all = 0, visible = 0, kept = 0;
  for (std::size_t s = 0; s < alone.size(); ++s) {
    all += alone[s].visible_cells;
    visible += behind[s].visible_cells;
    kept += behind[s].cells;
  }
  CHECK(kept == all);
  // The front block covers about the right half.
  CHECK(visible > 0.3 * all);
  CHECK(visible < 0.6 * all);
  for (const VisibleEdge& e : visible_edges(camera, objects, 0)) CHECK(e.object == 0);
}
