// SPDX-License-Identifier: Apache-2.0
#include "recognition/pose_search.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "golden/error.hpp"
#include "io/library.hpp"
#include "io/scene.hpp"
#include "io/views.hpp"
#include "recognition/remaining_lines.hpp"
#include "recognition/view_check.hpp"

using namespace trihedron;

namespace {

// A refinement converges from here (the objects are 50 to 100 mm large).
constexpr double kBasinMm = 10;
constexpr double kBasinRad = 0.17;

const std::string kVectors = TRIHEDRON_TESTVECTORS;

std::vector<View> views_of(const Scene& scene) { return make_views(scene, golden_front_end()); }

Eigen::Vector3d middle(const Model& m) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& x : m.mesh.vertices) sum += x;
  return sum / static_cast<double>(m.mesh.vertices.size());
}

bool in_basin(const Model& m, const Transform& estimate, const Transform& truth) {
  std::vector<Transform> motions = m.symmetries;
  motions.emplace_back();
  for (const Transform& s : motions) {
    const Transform t = truth * s;
    const double angle = Eigen::AngleAxisd(t.R.transpose() * estimate.R).angle();
    if ((t * middle(m) - estimate * middle(m)).norm() < kBasinMm && angle < kBasinRad) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("every object of the bundled scenes has a good pose among the first 200") {
  const std::vector<Model> library = read_library(kVectors + "/models10");
  const LibraryIndex index(library);
  for (const auto& folder : find_scenes(kVectors + "/scenes")) {
    const Scene scene = read_scene(folder);
    const PoseSearch search = search_poses(views_of(scene), library, index);
    for (const TrueObject& object : *scene.truth) {
      int rank = -1;
      for (std::size_t i = 0; i < search.hypotheses.size() && rank < 0; ++i) {
        const PoseHypothesis& h = search.hypotheses[i];
        const Model& m = library[static_cast<std::size_t>(h.model)];
        if (m.id != object.model_id) continue;
        if (in_basin(m, h.world_from_model, object.world_from_model)) rank = static_cast<int>(i);
      }
      INFO("scene " << folder << " object " << object.model_id);
      CHECK(rank >= 0);
      CHECK(rank < 200);
    }
  }
}

TEST_CASE("what a known object leaves shows the other one, and no segment of its own") {
  const std::vector<Model> library = read_library(kVectors + "/models10");
  const LibraryIndex index(library);
  int objects = 0;
  for (const auto& folder : find_scenes(kVectors + "/scenes")) {
    const Scene scene = read_scene(folder);
    if (scene.truth->size() != 2) continue;
    const std::vector<View> views = views_of(scene);
    const PoseSearch search = search_poses(views, library, index);
    for (std::size_t k = 0; k < 2; ++k) {
      const TrueObject &other = (*scene.truth)[1 - k], &wanted = (*scene.truth)[k];
      const auto of_id = [&](int id) {
        return &*std::find_if(library.begin(), library.end(),
                              [&](const Model& m) { return m.id == id; });
      };
      const std::vector<PlacedModel> known = {{of_id(other.model_id), other.world_from_model}};
      for (std::size_t v = 0; v < views.size(); ++v) {
        const ViewLines rest = remaining_lines(search.lines[v], views[v].camera, known);
        CHECK(rest.segments.size() < search.lines[v].segments.size());
        CHECK(rest.stops.size() == rest.segments.size());
        CHECK(remaining_lines(search.lines[v], views[v].camera, {}).segments.size() ==
              search.lines[v].segments.size());
      }
      const auto poses = search_rest(views, search, known, library, index);
      INFO("scene " << folder << " object " << wanted.model_id);
      CHECK(std::any_of(poses.begin(), poses.end(), [&](const PoseHypothesis& h) {
        const Model& m = library[static_cast<std::size_t>(h.model)];
        return m.id == wanted.model_id && in_basin(m, h.world_from_model, wanted.world_from_model);
      }));
      ++objects;
    }
  }
  CHECK(objects >= 4);
}

TEST_CASE("the search gives the same poses in the same order every time") {
  const std::vector<Model> library = read_library(kVectors + "/models10");
  const LibraryIndex index(library);
  const std::vector<View> views = views_of(read_scene(kVectors + "/scenes/lab-two/000050"));
  const PoseSearch a = search_poses(views, library, index);
  const PoseSearch b = search_poses(views, library, index);
  REQUIRE(a.hypotheses.size() == b.hypotheses.size());
  REQUIRE(!a.hypotheses.empty());
  for (std::size_t i = 0; i < a.hypotheses.size(); ++i) {
    CHECK(a.hypotheses[i].model == b.hypotheses[i].model);
    CHECK(a.hypotheses[i].support == b.hypotheses[i].support);
    CHECK(a.hypotheses[i].world_from_model.t == b.hypotheses[i].world_from_model.t);
  }
}

TEST_CASE("views that cannot be crossed are refused with a reason") {
  std::vector<View> views = views_of(read_scene(kVectors + "/scenes/studio-two/000034"));
  CHECK_NOTHROW(check_views(views));
  SECTION("one view") {
    views.resize(1);
    CHECK_THROWS_AS(check_views(views), Error);
  }
  SECTION("features of another size than the camera's") {
    views[1].features.width -= 1;
    CHECK_THROWS_WITH(check_views(views), Catch::Contains("view 1") && Catch::Contains("449x300"));
  }
  SECTION("a camera turned away from the table") {
    Transform& c = views[2].camera.camera_from_world;
    c.R = Eigen::Vector3d(-1, 1, -1).asDiagonal() * c.R;
    c.t = Eigen::Vector3d(-1, 1, -1).asDiagonal() * c.t;
    CHECK_THROWS_WITH(check_views(views),
                      Catch::Contains("view 2") && Catch::Contains("cam_R_w2c"));
  }
}
