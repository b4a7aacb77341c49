// SPDX-License-Identifier: Apache-2.0
#include "recognition/explanation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "recognition/lookalikes.hpp"
#include "recognition/rigs.hpp"
#include "recognition/solid_overlap.hpp"
#include "recognition/symmetry.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

/// `pose` a little off: what a search for poses hands over.
Transform nearby(const Transform& pose) {
  Vector6d motion;
  motion << 0.03, -0.04, 0.05, 2, -1.5, 1;
  return moved(pose, motion);
}

Model scaled(const Model& model, const Vector3d& factors) {
  Mesh mesh = model.mesh;
  for (Vector3d& v : mesh.vertices) v = v.cwiseProduct(factors);
  if (factors.prod() < 0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return build_model(model.id, model.name, mesh);
}

const Transform kPose = rigs::pose({0.1, 0.05, 0.6}, {-5, 4, 32});

}  // namespace

TEST_CASE("an object whose model is in the library is recognised, and said where") {
  const std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket()};
  const auto views = rigs::views_of({{&library[1], kPose}});
  const auto result = explain(views, library, {{0, nearby(kPose), 2}, {1, nearby(kPose), 1}});
  REQUIRE(result.objects.size() == 1);
  CHECK(result.objects[0].model_id == library[1].id);
  CHECK(pose_distance(library[1], result.objects[0].world_from_model, kPose) < 0.1);
  CHECK(result.objects[0].score > 0.9);
  CHECK_FALSE(result.objects[0].surfaces.empty());
  for (const Rejection& r : result.rejections) CHECK_FALSE(r.reason.empty());
}

TEST_CASE("a shape 10 % different in one dimension is refused") {
  const Model truth = rigs::l_bracket();
  const auto views = rigs::views_of({{&truth, kPose}});
  for (const Vector3d& factors : {Vector3d(1.1, 1, 1), Vector3d(0.9, 1, 1), Vector3d(1, 1.1, 1),
                                  Vector3d(1, 0.9, 1), Vector3d(1, 1, 1.1), Vector3d(1, 1, 0.9)}) {
    const std::vector<Model> library = {scaled(truth, factors)};
    INFO("scaled by " << factors.transpose());
    CHECK(explain(views, library, {{0, nearby(kPose), 1}}).objects.empty());
  }
}

TEST_CASE("a model that lies the wrong way round is turned or refused, never reported as it is") {
  // The L is its own mirror image across its thickness; mirrored in x it lies the other way.
  const Model truth = rigs::l_bracket();
  const std::vector<Model> library = {scaled(truth, {-1, 1, 1})};
  const auto views = rigs::views_of({{&truth, kPose}});
  for (const auto& object : explain(views, library, {{0, nearby(kPose), 1}}).objects) {
    double distance = 1e9;
    for (const Transform& same : congruences(library[0], truth)) {
      distance =
          std::min(distance, pose_distance(library[0], object.world_from_model, kPose * same));
    }
    CHECK(distance < 0.1);
  }
}

TEST_CASE("each surface that a view shows is described and matched") {
  const std::vector<Model> library = {rigs::block(60, 50, 40)};
  const auto result =
      explain(rigs::views_of({{&library[0], kPose}}), library, {{0, nearby(kPose), 1}});
  REQUIRE(result.objects.size() == 1);
  CHECK(result.objects[0].surfaces.size() >= 6);  // two or three of a block in each view
  int complete = 0;
  for (const SurfaceMatch& match : result.objects[0].surfaces) {
    REQUIRE(match.scene_surface >= 0);
    const SceneSurface& seen = result.surfaces.at(match.scene_surface);
    const Surface& model = library[0].surfaces.at(match.model_surface);
    CHECK(seen.view == match.view);
    CHECK(match.visible_share == 1);  // nothing hides it
    CHECK(seen.normal.dot(kPose.R * model.normal) > 0.999);
    if (!seen.complete) continue;
    ++complete;
    constexpr double kMeasured = 0.02;  // edges to 0.2 mm on 40 mm, four of them
    CHECK(seen.area == Approx(model.area).epsilon(kMeasured));
    CHECK((seen.centroid - kPose * model.centroid).norm() < 0.3);
    CHECK(match.found_share > 0.5);
  }
  CHECK(complete >= 3);
}

TEST_CASE("a rejected hypothesis says how the shape differs") {
  const Model truth = rigs::block(60, 50, 40);
  const auto views = rigs::views_of({{&truth, kPose}});
  const std::vector<Model> library = {rigs::block(66, 50, 40)};
  const auto result = explain(views, library, {{0, nearby(kPose), 1}});
  REQUIRE(result.rejections.size() == 1);
  CHECK_THAT(result.rejections[0].reason, Catch::Matchers::Contains("similar shape: surface"));
}

TEST_CASE("a model is told from its mirror image by the one corner that differs") {
  const Model truth = rigs::centred(1, "cut", shapes::cut_block());
  const Model mirrored = scaled(truth, {-1, 1, 1});
  const Transform seen = rigs::pose({0.1, 0.05, 0.6}, {-5, 4, 32});
  CHECK(explain(rigs::views_of({{&truth, seen}}), {truth}, {{0, nearby(seen), 1}}).objects.size() ==
        1);
  for (const Transform& turn : find_lookalikes(truth).mirrored_onto) {
    // The model in the place of its mirror image.
    const auto views = rigs::views_of({{&mirrored, seen}});
    CHECK(explain(views, {truth}, {{0, seen * turn.inverse(), 1}}).objects.empty());
  }
}

TEST_CASE("where no view would show the corner that differs, the model is refused") {
  const Model truth = rigs::centred(1, "cut", shapes::cut_block());
  // Turned over, the cut corner lies on the table, away from the front camera and the side camera.
  const Transform over =
      rigs::pose({0, 0, 0.02}, {0, 0, 20}) * rigs::pose({0, 3.14159265358979, 0}, {0, 0, 0});
  auto views = rigs::views_of({{&truth, over}});
  // The mirror image would show its own to one of three cameras, not to the first two.
  CHECK(explain(views, {truth}, {{0, over, 1}}).objects.size() == 1);
  views.pop_back();
  const auto result = explain(views, {truth}, {{0, over, 1}});
  CHECK(result.objects.empty());
  REQUIRE_FALSE(result.rejections.empty());
}

TEST_CASE("a pose that agrees in most edges gives way to the one that agrees in all") {
  const Model truth = rigs::centred(1, "cut", shapes::cut_block());
  const auto views = rigs::views_of({{&truth, kPose}});
  int right = 0;
  for (const Transform& turn : find_lookalikes(truth).turned) {
    const auto result = explain(views, {truth}, {{0, kPose * turn, 1}});
    for (const RecognizedObject& object : result.objects) {
      CHECK(pose_distance(truth, object.world_from_model, kPose) < 0.1);
      ++right;
    }
  }
  CHECK(right > 0);
}

TEST_CASE("objects that hide each other are all recognised") {
  const std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket()};
  const Transform front = rigs::pose({0, 0, 0.3}, {10, -45, 21});
  const Transform behind = rigs::pose({0, 0, 0.9}, {-5, 35, 21});
  const auto views = rigs::views_of({{&library[0], front}, {&library[1], behind}});
  const auto result =
      explain(views, library, {{1, nearby(behind), 3}, {0, nearby(front), 2}, {0, behind, 1}});
  REQUIRE(result.objects.size() == 2);
  CHECK(result.objects[0].model_id != result.objects[1].model_id);
}

TEST_CASE("an object that could be either of two is no answer, but hides what lies behind it") {
  std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket(),
                                rigs::block(60, 50, 40)};
  library[2].id = 3;
  const Transform front = rigs::pose({0, 0, 0.3}, {10, -45, 21});
  const Transform behind = rigs::pose({0, 0, 0.9}, {-5, 35, 21});
  const auto views = rigs::views_of({{&library[0], front}, {&library[1], behind}});
  const auto result =
      explain(views, library,
              {{1, nearby(behind), 4}, {0, nearby(front), 3}, {2, front, 2}, {1, behind, 1}});
  REQUIRE(result.objects.size() == 1);
  CHECK(result.objects[0].model_id == library[1].id);
  CHECK(pose_distance(library[1], result.objects[0].world_from_model, behind) < 0.2);
}

TEST_CASE("a plain block is not taken for the wedge that is half of it") {
  const std::vector<Model> library = {
      rigs::centred(1, "wedge", shapes::prism({{0, 0}, {60, 0}, {0, 40}}, 50))};
  const Model block = rigs::block(60, 40, 50);
  // The wedge's centre lies a sixth of each leg below and left of the block's.
  const Transform in_block = rigs::pose({0, 0, 0}, {-10, -40.0 / 6, 0});
  const Transform turns[] = {rigs::pose({1.5, 0, 0.3}, {0, 0, 22}),
                             rigs::pose({0, 0, 0.4}, {0, 0, 26}),
                             rigs::pose({-1.6, 0, 0.2}, {0, 0, 22})};
  for (const Transform& pose : turns) {
    const auto views = rigs::views_of({{&block, pose}});
    CHECK(explain(views, library, {{0, pose * in_block, 1}}).objects.empty());
  }
}

TEST_CASE("an object half hidden by an unknown one is told from all that is like it") {
  const std::vector<Model> library = {rigs::block(66, 50, 40), rigs::l_bracket()};
  const Model shorter = rigs::block(60, 50, 40);
  const Transform front = rigs::pose({0, 0, 0.3}, {10, -45, 21});
  const Transform behind = rigs::pose({0, 0, 0.9}, {-5, 35, 21});
  const auto views = rigs::views_of({{&shorter, front}, {&library[1], behind}});
  const auto result =
      explain(views, library, {{1, nearby(behind), 3}, {0, nearby(front), 2}, {1, behind, 1}});
  REQUIRE(result.objects.size() == 1);
  CHECK(result.objects[0].model_id == library[1].id);
  CHECK(pose_distance(library[1], result.objects[0].world_from_model, behind) < 0.2);
}

TEST_CASE("two unknown objects, one in front of the other, do not vouch for each other") {
  const Model bracket = rigs::l_bracket(), block = rigs::block(60, 50, 40);
  const Transform front = rigs::pose({0, 0, 0.3}, {10, -45, 21});
  const Transform behind = rigs::pose({0, 0, 0.9}, {-5, 35, 21});
  const auto views = rigs::views_of({{&block, front}, {&bracket, behind}});
  for (int axis = 0; axis < 3; ++axis) {
    Vector3d longer(1, 1, 1);
    longer[axis] = 1.1;
    const std::vector<Model> library = {scaled(block, longer), scaled(bracket, longer)};
    INFO("longer along axis " << axis);
    CHECK(explain(views, library,
                  {{1, nearby(behind), 3}, {0, nearby(front), 2}, {1, behind, 1}, {0, front, 1}})
              .objects.empty());
  }
}

TEST_CASE("an empty scene has no objects") {
  const std::vector<Model> library = {rigs::block(60, 50, 40)};
  const auto result = explain(rigs::views_of({}), library, {{0, kPose, 1}});
  CHECK(result.objects.empty());
}

TEST_CASE("solids overlap when they share space, not when they touch") {
  const Model block = rigs::block(40, 40, 40);
  const InnerPoints inner = inner_points(block, 2);
  CHECK(inside(block, {0, 0, 0}));
  CHECK_FALSE(inside(block, {21, 0, 0}));
  const PlacedModel a{&block, {}};
  CHECK(overlap(a, inner, {&block, rigs::pose({0, 0, 0}, {30, 0, 0})}, inner));
  CHECK_FALSE(overlap(a, inner, {&block, rigs::pose({0, 0, 0}, {39, 0, 0})}, inner));
}

TEST_CASE("the runner-up is the best other answer for an object's place, and less good") {
  const std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket()};
  const auto views = rigs::views_of({{&library[1], kPose}});
  // The block has the bracket's three dimensions: it fits but for the step.
  const auto both = explain(views, library, {{0, nearby(kPose), 2}, {1, nearby(kPose), 1}});
  REQUIRE(both.objects.size() == 1);
  CHECK(both.objects[0].model_id == library[1].id);
  CHECK(both.objects[0].runner_up_model_id == library[0].id);
  CHECK(both.objects[0].runner_up_score > 0);
  CHECK(both.objects[0].runner_up_score < both.objects[0].score);
  const auto alone = explain(views, library, {{1, nearby(kPose), 1}});
  REQUIRE(alone.objects.size() == 1);
  CHECK(alone.objects[0].runner_up_model_id == -1);
  CHECK(alone.objects[0].runner_up_score == 0);
}
