// SPDX-License-Identifier: Apache-2.0
#include "recognition/evaluation.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "recognition/shapes.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

const std::vector<Model>& library() {
  static const std::vector<Model> models = {
      build_model(1, "block", shapes::block(40, 50, 60)),
      build_model(2, "hex", shapes::regular_prism(6, 30, 50))};
  return models;
}

Transform pose(double angle, const Vector3d& t) {
  return {Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(), t};
}

RecognizedObject object(int model_id, const Transform& at, double score = 1) {
  RecognizedObject out;
  out.model_id = model_id;
  out.world_from_model = at;
  out.score = score;
  return out;
}

}  // namespace

TEST_CASE("a shift is its own pose error") {
  const PoseError e = pose_error(library()[0], pose(0.3, {3, 4, 12}), pose(0.3, {0, 0, 0}));
  CHECK(e.largest_mm == Approx(13));
  CHECK(e.mean_mm == Approx(13));
}

TEST_CASE("a turn by a symmetry is no error, half of it is") {
  const double sixth = 3.14159265358979323846 / 3;
  CHECK(pose_error(library()[1], pose(sixth, {1, 2, 3}), pose(0, {1, 2, 3})).largest_mm < 1e-9);
  CHECK(pose_error(library()[1], pose(sixth / 2, {0, 0, 0}), pose(0, {0, 0, 0})).largest_mm ==
        Approx(2 * 30 * std::sin(sixth / 4)));
}

TEST_CASE("right, wrong and missed objects are counted") {
  RecognitionResult result;
  const std::vector<TrueObject> truth = {
      {1, pose(0, {0, 0, 0})}, {1, pose(0, {200, 0, 0})}, {2, pose(0, {0, 200, 0})}};
  result.objects = {object(1, pose(0, {1, 0, 0})),     // right
                    object(1, pose(0, {3, 0, 0})),     // the same true object again: wrong
                    object(2, pose(0, {200, 0, 0}))};  // another model's place: wrong
  const SceneScore score = score_scene(result, truth, library());
  CHECK(score.wrong == 2);
  REQUIRE(score.objects.size() == 3);
  CHECK(score.objects[0].right);
  CHECK(score.objects[0].vertex_mm == Approx(1));
  CHECK(score.objects[0].recall == 1);
  CHECK_FALSE(score.objects[1].right);
  CHECK(score.objects[1].recall == 0);
  CHECK_FALSE(score.objects[2].right);
}

TEST_CASE("the surer result takes the object") {
  RecognitionResult result;
  result.objects = {object(1, pose(0, {1, 0, 0}), 0.4), object(1, pose(0, {2, 0, 0}), 0.9)};
  const SceneScore score = score_scene(result, {{1, pose(0, {0, 0, 0})}}, library());
  CHECK(score.objects[0].vertex_mm == Approx(2));
  CHECK(score.wrong == 1);
}

TEST_CASE("20 % of the diameter is the border between right and wrong") {
  const double border = 0.2 * library()[0].diameter;
  for (double shift : {0.99 * border, 1.01 * border}) {
    RecognitionResult result;
    result.objects = {object(1, pose(0, {shift, 0, 0}))};
    const SceneScore score = score_scene(result, {{1, pose(0, {0, 0, 0})}}, library());
    CHECK(score.objects[0].right == (shift < border));
    if (shift < border) CHECK(score.objects[0].recall == Approx(0.7));  // 20, 25 .. 50 %
  }
}

TEST_CASE("a surface is right where the true object has the surface it was taken for") {
  const Model& block = library()[0];
  const Transform at = pose(0.4, {10, 20, 30});
  RecognitionResult result;
  result.objects = {object(1, at)};
  for (int s = 0; s < 3; ++s) {
    SceneSurface surface;
    surface.normal = at.R * block.surfaces[s].normal;
    surface.centroid = at * block.surfaces[s].centroid;
    result.surfaces.push_back(surface);
    result.objects[0].surfaces.push_back({0, s, s});
  }
  result.surfaces[1].complete = false;              // not described
  result.objects[0].surfaces[2].model_surface = 0;  // taken for another one
  const SceneScore score = score_scene(result, {{1, at}}, library());
  CHECK(score.surfaces_described == 2);
  CHECK(score.surfaces_right == 1);
}
