// SPDX-License-Identifier: Apache-2.0
#include "report/scene_data.hpp"

#include <catch2/catch.hpp>

#include "io/library.hpp"
#include "io/views.hpp"
#include "report/space.hpp"

using namespace trihedron;
using report::Json;

namespace {

const std::string kScene = TRIHEDRON_TESTVECTORS "/scenes/studio-two/000034";

/// The bundled scene as if recognition had answered with the truth.
struct Fixture {
  Scene scene = read_scene(kScene);
  std::vector<Model> library = read_library(TRIHEDRON_TESTVECTORS "/models10");
  std::vector<View> views = make_views(scene, golden_front_end());
  RecognitionResult result;

  Fixture() {
    for (const TrueObject& object : *scene.truth) {
      result.objects.push_back({});
      result.objects.back().model_id = object.model_id;
      result.objects.back().world_from_model = object.world_from_model;
    }
  }
  report::RecognizedScene input() const {
    return {scene, views, library, result, "golden", "full", {}};
  }
};

Eigen::Vector3d point(const Json& flat, std::size_t i) {
  const auto at = [&](std::size_t k) { return flat.at(3 * i + k).get<double>(); };
  return {at(0), at(1), at(2)};
}

}  // namespace

TEST_CASE("a page shows what left the hardware's ports, view by view") {
  const Fixture fixture;
  const Json data = report::scene_data(fixture.input());
  REQUIRE(data.at("views").size() == 3);
  for (std::size_t v = 0; v < 3; ++v) {
    const Json& view = data["views"][v];
    const ViewFeatures& features = fixture.views[v].features;
    CHECK(view.at("width") == features.width);
    CHECK(view.at("vertices").size() == features.vertices.size());
    CHECK(view.at("vertices")[0][0] == features.vertices[0].x);
    const auto on_contour = std::count_if(features.contour.begin(), features.contour.end(),
                                          [](const ContourBeat& beat) { return beat.contour(); });
    CHECK(view.at("contour_px") == on_contour);
    CHECK_FALSE(view.at("segments").empty());
    CHECK_FALSE(view.at("regions").empty());
  }
}

TEST_CASE("models at their true places leave residuals below a pixel where edges are measured") {
  const Fixture fixture;
  const Json data = report::scene_data(fixture.input());
  double squares = 0;
  int measured = 0;
  for (const Json& view : data.at("views"))
    for (const Json& object : view.at("objects"))
      for (const Json& sample : object.at("residuals")) {
        if (sample.size() == 2) continue;
        squares += std::pow(sample[2].get<double>(), 2) + std::pow(sample[3].get<double>(), 2);
        ++measured;
      }
  constexpr int kLeast = 300;      // two objects, three views, an edge point every 4 px
  constexpr double kMostPx = 0.7;  // lines that run side by side disturb each other's profiles
  CHECK(measured > kLeast);
  CHECK(std::sqrt(squares / measured) < kMostPx);
}

TEST_CASE("without a simulation the hardware's counters are null, never zeros") {
  const Fixture fixture;
  CHECK(report::scene_data(fixture.input()).at("hardware").is_null());
  report::RecognizedScene input = fixture.input();
  input.hardware = {1000, {{500, 1, 2, 500, 0, 54, 9, 0, 0}}};
  const Json hardware = report::scene_data(input).at("hardware");
  CHECK(hardware.at("clocks") == 1000);
  CHECK(hardware.at("views").at(0).at("latency_clocks") == 54);
}

TEST_CASE("a line of the overview compares with the truth") {
  Fixture fixture;
  CHECK(report::scene_line(fixture.input()).at("truth").at("objects").at(0).at("right") == true);
  fixture.result.objects[0].world_from_model.t.x() += 100;  // mm: more than any model's size
  const Json line = report::scene_line(fixture.input());
  CHECK(line.at("truth").at("objects").at(0).at("right") == false);
  CHECK(line.at("truth").at("wrong") == 1);
  fixture.scene.truth.reset();
  CHECK(report::scene_line(fixture.input()).at("truth").is_null());
}

TEST_CASE("a scene fails by what it misses or invents, not by objects that nobody could know") {
  Fixture fixture;
  CHECK_FALSE(report::failed(fixture.input()));
  const RecognizedObject second = fixture.result.objects[1];
  fixture.result.objects.pop_back();
  CHECK(report::failed(fixture.input()));  // missed
  (*fixture.scene.truth)[1].model_id = 900001;
  CHECK_FALSE(report::failed(fixture.input()));  // not in the library, and not claimed
  fixture.result.objects.push_back(second);
  CHECK(report::failed(fixture.input()));  // claimed
  fixture.scene.truth.reset();
  CHECK_FALSE(report::failed(fixture.input()));
  fixture.result.objects.clear();
  CHECK(report::failed(fixture.input()));  // nothing found, and nobody says that this is right
}

TEST_CASE("a picture placed in space by its corners' rays is what the camera sees") {
  const Fixture fixture;
  const Eigen::Vector3d focus = report::looked_at(fixture.scene.cameras);
  for (const Camera& camera : fixture.scene.cameras) {
    const Json drawn = report::space_camera(camera, focus);
    const double depth = drawn.at("distance");
    const double x = camera.width_px - 0.5, y = camera.height_px - 0.5;
    const Eigen::Vector2d corners[] = {{-0.5, -0.5}, {x, -0.5}, {x, y}, {-0.5, y}};
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d place =
          point(drawn.at("origins"), i) + depth * point(drawn.at("directions"), i);
      constexpr double kRoundingPx = 0.01;  // of three decimals mm and six of directions
      CHECK((camera.project(place) - corners[i]).norm() < kRoundingPx);
    }
    constexpr double kInPicture = 0.25;  // of its size: the rig looks at one place
    const Eigen::Vector2d off = camera.project(focus) - 0.5 * (corners[0] + corners[2]);
    CHECK(off.norm() < kInPicture * camera.width_px);
  }
}
