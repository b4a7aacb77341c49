// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "recognition/paper_hypotheses.hpp"
#include "recognition/paper_positioning.hpp"
#include "recognition/paper_scenes.hpp"
#include "recognition/paper_verification.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

SurfaceAttributes square(double side) {
  return surface_attributes({{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}});
}

SurfaceAttributes facing(const Vector3d& normal, const Vector3d& centroid) {
  SurfaceAttributes s;
  s.normal = normal.normalized();
  s.centroid = centroid;
  return s;
}

/// The surfaces of a model, placed, as a scene.
PaperScene placed(const Model& model, const Transform& pose, const std::vector<int>& which) {
  PaperScene scene;
  scene.error_mm = 0.5;
  for (const int i : which) {
    std::vector<SpacePolygon> loops = surface_loops(model, i);
    for (SpacePolygon& loop : loops) {
      for (Vector3d& v : loop) v = pose * v;
    }
    scene.surfaces.push_back(surface_attributes(loops));
    scene.loops.push_back(loops);
  }
  return scene;
}

/// A tetrahedron with four different faces, and the same in the mirror.
Model tetrahedron(bool mirrored) {
  const double s = mirrored ? -1 : 1;
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {s * 60, 0, 0}, {s * 15, 45, 0}, {s * 25, 12, 50}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  if (mirrored) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return build_model(1, mirrored ? "mirrored" : "original", mesh);
}

std::vector<std::vector<int>> only_own(std::size_t count) {
  std::vector<std::vector<int>> candidates;
  for (std::size_t i = 0; i < count; ++i) candidates.push_back({static_cast<int>(i)});
  return candidates;
}

}  // namespace

TEST_CASE("attributes of a polygon with a hole") {
  const SpacePolygon outer = {{0, 0, 5}, {10, 0, 5}, {10, 8, 5}, {0, 8, 5}};
  const SpacePolygon hole = {{2, 2, 5}, {2, 4, 5}, {4, 4, 5}, {4, 2, 5}};
  const SurfaceAttributes a = surface_attributes({outer, hole});
  CHECK(a.area == Approx(80 - 4));
  CHECK(a.perimeter == Approx(36 + 8));
  CHECK(a.edges() == 8);
  CHECK((a.normal - Vector3d::UnitZ()).norm() < 1e-12);
  CHECK(a.centroid.x() == Approx((80 * 5 - 4 * 3) / 76.0));
  CHECK(a.centroid.y() == Approx((80 * 4 - 4 * 3) / 76.0));
}

TEST_CASE("attributes computed from a model's vertices are those of its surfaces") {
  const Model bracket = rigs::l_bracket();
  for (std::size_t i = 0; i < bracket.surfaces.size(); ++i) {
    const SurfaceAttributes a = surface_attributes(bracket, static_cast<int>(i));
    CHECK(a.area == Approx(bracket.surfaces[i].area));
    CHECK(a.perimeter == Approx(bracket.surfaces[i].perimeter));
    CHECK((a.normal - bracket.surfaces[i].normal).norm() < 1e-9);
    CHECK((a.centroid - bracket.surfaces[i].centroid).norm() < 1e-9);
  }
}

TEST_CASE("a scene surface matches a model surface up to 20 percent of the model's values") {
  const SurfaceAttributes model = square(50);
  SurfaceAttributes scene = square(50);
  CHECK(surfaces_match(scene, model));
  scene.area = model.area * 1.19;
  CHECK(surfaces_match(scene, model));
  scene.area = model.area * 1.21;
  CHECK_FALSE(surfaces_match(scene, model));
  scene = square(50);
  scene.perimeter = model.perimeter * 0.79;
  CHECK_FALSE(surfaces_match(scene, model));
  scene = square(50);
  scene.edge_lengths.push_back(50);  // five edges instead of four: 25 %
  CHECK_FALSE(surfaces_match(scene, model));
  scene = square(50);
  scene.edge_lengths = {61, 61, 61, 61};
  CHECK_FALSE(surfaces_match(scene, model));
  scene.edge_lengths = {61, 61, 61, 59};  // one edge is enough
  CHECK(surfaces_match(scene, model));
}

TEST_CASE("the pre-test bounds area and edge count by the model's extremes") {
  const PaperModel model = paper_model(rigs::block(60, 50, 40));
  CHECK(model.surfaces.size() == 6);
  CHECK(model.min_area == Approx(2000));
  CHECK(model.max_area == Approx(3000));
  CHECK(model.min_edges == 4);
  CHECK(model.max_edges == 4);
  SurfaceAttributes scene = square(50);
  CHECK(passes_pretest(scene, model));
  scene.area = 1.19 * 3000;
  CHECK(passes_pretest(scene, model));
  scene.area = 1.21 * 3000;
  CHECK_FALSE(passes_pretest(scene, model));
  scene.area = 0.79 * 2000;
  CHECK_FALSE(passes_pretest(scene, model));
  scene = square(50);
  scene.edge_lengths.push_back(50);
  CHECK_FALSE(passes_pretest(scene, model));
}

TEST_CASE("pairs agree up to 0.28 in the cosine and 10 percent in the distance") {
  const SurfaceAttributes a = facing({0, 0, 1}, {0, 0, 0}), v = a;
  const auto at_cosine = [](double cosine, double distance) {
    return facing({std::sqrt(1 - cosine * cosine), 0, cosine}, {distance, 0, 0});
  };
  const SurfaceAttributes w = at_cosine(0, 40);
  CHECK(pair_error(a, at_cosine(0.279, 40), v, w) < 1);
  CHECK(pair_error(a, at_cosine(0.281, 40), v, w) > 1);
  CHECK(pair_error(a, at_cosine(0, 43.9), v, w) < 1);
  CHECK(pair_error(a, at_cosine(0, 44.1), v, w) > 1);
  CHECK(pair_error(a, at_cosine(0, 35.9), v, w) > 1);
  const SurfaceAttributes concentric = facing({1, 0, 0}, {0, 0, 0});
  CHECK(pair_error(a, concentric, v, concentric) == 0);
  CHECK(pair_error(a, at_cosine(0, 1), v, concentric) > 1);
}

TEST_CASE("sequences close, use no surface twice and come longest first") {
  const Model box = rigs::block(60, 50, 40);
  const PaperModel model = paper_model(box);
  const PaperScene scene = placed(box, rigs::pose({0.3, -0.2, 1}, {10, 20, 30}), {0, 1, 2});
  const std::vector<std::vector<int>> all(3, {0, 1, 2, 3, 4, 5});
  const SequenceSearch search = closed_sequences(scene.surfaces, model.surfaces, all);
  REQUIRE_FALSE(search.sequences.empty());
  CHECK_FALSE(search.truncated);
  CHECK(search.sequences.front().size() == 3);
  std::size_t last = 3;
  for (const PaperSequence& sequence : search.sequences) {
    CHECK(sequence.size() >= 2);
    CHECK(sequence.size() <= last);
    last = sequence.size();
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        CHECK(sequence[i].scene_surface != sequence[j].scene_surface);
        CHECK(sequence[i].model_surface != sequence[j].model_surface);
      }
    }
  }
}

TEST_CASE("surfaces that fit no pair make no sequence") {
  const std::vector<SurfaceAttributes> model = {facing({0, 0, 1}, {0, 0, 0}),
                                                facing({1, 0, 0}, {30, 0, 0})};
  const std::vector<SurfaceAttributes> scene = {model[0], facing({1, 0, 0}, {60, 0, 0})};
  CHECK(closed_sequences(scene, model, only_own(2)).sequences.empty());
  CHECK(closed_sequences({model[0]}, model, only_own(1)).sequences.empty());
}

TEST_CASE("a path of agreeing neighbours that does not close is no sequence") {
  // a - b and b - c agree, c - a does not
  const std::vector<SurfaceAttributes> model = {
      facing({0, 0, 1}, {0, 0, 0}), facing({0, 0, 1}, {30, 0, 0}), facing({0, 0, 1}, {60, 0, 0})};
  std::vector<SurfaceAttributes> scene = model;
  scene[2].centroid = {30, 30, 0};
  for (const PaperSequence& s : closed_sequences(scene, model, only_own(3)).sequences)
    CHECK(s.size() == 2);
}

TEST_CASE("two-step positioning brings centroid, normal and edge into place") {
  const Model bracket = rigs::l_bracket();
  const Transform truth = rigs::pose({0.4, 1.1, -0.7}, {30, -20, 50});
  for (int i = 0; i < static_cast<int>(bracket.surfaces.size()); ++i) {
    const PaperScene scene = placed(bracket, truth, {i});
    const Transform pose =
        position_surface(scene.surfaces[0], 1, surface_attributes(bracket, i), 1);
    for (const Vector3d& v : bracket.mesh.vertices) {
      CHECK((pose * v - truth * v).norm() < 1e-9);
    }
    CHECK(pose.R.determinant() == Approx(1));
  }
}

TEST_CASE("positioning turns surfaces that look the opposite way") {
  const Model box = rigs::block(60, 50, 40);
  const SurfaceAttributes model = surface_attributes(box, 0);
  for (const double sign : {1.0, -1.0}) {
    SpacePolygon loop = surface_loops(box, 0)[0];
    if (sign < 0) {  // half a turn about an axis in the surface
      const Vector3d axis = model.normal.unitOrthogonal();
      for (Vector3d& v : loop) v = Eigen::AngleAxisd(3.14159265358979, axis) * v;
    }
    const SurfaceAttributes scene = surface_attributes({loop});
    REQUIRE(scene.normal.dot(model.normal) == Approx(sign));
    const Transform pose = position_surface(scene, 0, model, 0);
    CHECK((pose.R * model.normal - scene.normal).norm() < 1e-6);
    CHECK((pose * model.edge_middles[0] - scene.edge_middles[0]).norm() < 1e-6);
    CHECK(pose.R.determinant() == Approx(1));
  }
}

TEST_CASE("a mirrored arrangement passes every pair but finds no position") {
  const Model original = tetrahedron(false), mirrored = tetrahedron(true);
  const PaperModel model = paper_model(original);
  const PaperScene right = placed(original, rigs::pose({0, 0, 1}, {5, 5, 0}), {0, 1, 2, 3});
  const PaperScene wrong = placed(mirrored, rigs::pose({0, 0, 1}, {5, 5, 0}), {0, 1, 2, 3});
  for (const PaperScene* scene : {&right, &wrong}) {
    const auto search = closed_sequences(scene->surfaces, model.surfaces, only_own(4));
    REQUIRE_FALSE(search.sequences.empty());
    REQUIRE(search.sequences[0].size() == 4);
    const auto position = position_model(*scene, original, model.surfaces, search.sequences[0]);
    CHECK(position.has_value() == (scene == &right));
    if (position) CHECK(position->error_mm < 1e-9);
  }
}

TEST_CASE("the smallest dimension is the least distance of two planes around the model") {
  CHECK(smallest_dimension_mm(rigs::block(60, 50, 40)) == Approx(40));
  CHECK(smallest_dimension_mm(rigs::l_bracket()) == Approx(40));
}
