// SPDX-License-Identifier: Apache-2.0
#include "render/view.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "io/library.hpp"
#include "recognition/shapes.hpp"
#include "render/scene_files.hpp"

using namespace trihedron;
using namespace trihedron::render;

namespace {

const std::string kVectors = TRIHEDRON_TESTVECTORS;

// A camera 500 mm above the table that looks straight down.
Camera camera_above(Camera::Projection projection) {
  Camera camera;
  camera.view = "top";
  camera.projection = projection;
  camera.width_px = 120;
  camera.height_px = 100;
  camera.K << 500, 0, 59.5, 0, 500, 49.5, 0, 0, 1;
  camera.px_per_mm = 1;
  camera.camera_from_world.R = Eigen::Vector3d(1, -1, -1).asDiagonal();
  camera.camera_from_world.t = {0, 0, 500};
  return camera;
}

World world_of(const Model& model, const Eigen::Vector3d& at) {
  World world;
  world.objects.push_back({&model, {Eigen::Matrix3d::Identity(), at}, 1});
  world.ambient = 100;
  world.background = 20;
  world.table.present = false;
  return world;
}

// Part of the samples in which two truth images name different surfaces.
double disagreement(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat different;
  cv::compare(a, b, different, cv::CMP_NE);
  return static_cast<double>(cv::countNonZero(different)) / static_cast<double>(a.total());
}

void check_against_truth(const std::string& scene) {
  const std::filesystem::path folder = kVectors + "/scenes/" + scene;
  const std::vector<Model> library = read_library(kVectors + "/models10");
  const std::vector<Camera> cameras = read_cameras(folder / "scene_camera.json");
  World world;
  world.objects = read_objects(folder / "scene_gt.json", cameras, library);
  // Both sides round the position of a border; it may pass a sample here and there.
  constexpr double kBorderSamples = 1e-5;
  for (std::size_t v = 0; v < cameras.size(); ++v) {
    CAPTURE(scene, v);
    const cv::Mat truth =
        cv::imread((folder / "surfaces" / ("00000" + std::to_string(v) + ".png")).string(),
                   cv::IMREAD_UNCHANGED);
    REQUIRE(truth.type() == CV_16U);
    const RenderedView view = render_view(world, cameras[v], {}, 1);
    REQUIRE(view.surfaces.size() == truth.size());
    REQUIRE(cv::countNonZero(truth) > 10000);
    CHECK(disagreement(view.surfaces, truth) <= kBorderSamples);
  }
}

}  // namespace

TEST_CASE("the surfaces of a perspective scene are those of the independent ray tracer") {
  check_against_truth("lab-stacked/000056");
}

TEST_CASE("the surfaces of an orthographic scene are those of the independent ray tracer") {
  check_against_truth("cad-isolated/000001");
}

TEST_CASE("an orthographic block covers as many samples as its area says") {
  const Model block = build_model(1, "block", shapes::block(40, 20, 10));
  const World world = world_of(block, {-20.1, -10.1, 0});  // off the grid of samples
  const RenderedView view =
      render_view(world, camera_above(Camera::Projection::kOrthographic), {}, 1);
  CHECK(cv::countNonZero(view.surfaces) == 40 * 20 * kSubsamples * kSubsamples);
  CHECK(view.visible_fraction[0] == 1);
}

TEST_CASE("a pinhole block covers its top face's projection and shows only that face") {
  const Model block = build_model(1, "block", shapes::block(40, 20, 100));
  const World world = world_of(block, {-20, -10, 0});
  const RenderedView view = render_view(world, camera_above(Camera::Projection::kPinhole), {}, 1);
  // The top is 400 mm away: 1.25 px per mm.
  CHECK(cv::countNonZero(view.surfaces) == 50 * 25 * kSubsamples * kSubsamples);
  std::set<int> surfaces(view.surfaces.begin<std::uint16_t>(), view.surfaces.end<std::uint16_t>());
  CHECK(surfaces.size() == 2);
}

TEST_CASE("a distorted camera sees a vertex where Camera::project says") {
  const Model block = build_model(1, "block", shapes::block(30, 20, 10));
  Camera camera = camera_above(Camera::Projection::kPinhole);
  camera.distortion = {-0.3, 0.1, 0.002, -0.001, 0};
  const World world = world_of(block, {10, 5, 0});
  const RenderedView view = render_view(world, camera, {}, 1);
  cv::Mat covered = view.surfaces > 0;
  const cv::Rect box = cv::boundingRect(covered);
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector3d& v : block.mesh.vertices) {
    const Eigen::Vector2d p = camera.project(v + Eigen::Vector3d(10, 5, 0));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Extremes of the outline are vertices up to the edges' bulge, below a sample here.
  const double sample = 1.0 / kSubsamples;
  CHECK(box.x * sample - 0.5 == Approx(low.x()).margin(2 * sample));
  CHECK(box.y * sample - 0.5 == Approx(low.y()).margin(2 * sample));
  CHECK(box.br().x * sample - 0.5 == Approx(high.x()).margin(2 * sample));
  CHECK(box.br().y * sample - 0.5 == Approx(high.y()).margin(2 * sample));
}

TEST_CASE("the visible fraction of a half hidden object is one half") {
  const Model low = build_model(1, "low", shapes::block(40, 20, 10));
  const Model high = build_model(2, "high", shapes::block(20, 20, 30));
  World world = world_of(low, {-20, -10, 0});
  world.objects.push_back({&high, {Eigen::Matrix3d::Identity(), {0, -10, 10}}, 1});
  const RenderedView view =
      render_view(world, camera_above(Camera::Projection::kOrthographic), {}, 1);
  CHECK(view.visible_fraction[0] == Approx(0.5));
  CHECK(view.visible_fraction[1] == 1);
}

TEST_CASE("a lamp straight above casts the shadow of a block on the table below") {
  const Model block = build_model(1, "block", shapes::block(20, 20, 10));
  World world = world_of(block, {-10, -10, 30});
  world.ambient = 0;
  world.table = {true, {-200, -200}, {200, 200}, 0.5};
  world.lights.push_back({{0, 0, 10000}, 0, 100, true});
  Camera side = camera_above(Camera::Projection::kOrthographic);
  // Looks along (0, 0.8, -0.6): below the block, the table under it is in sight.
  side.camera_from_world.R << 1, 0, 0, 0, -0.6, -0.8, 0, 0.8, -0.6;
  const RenderedView view = render_view(world, side, {}, 1);
  const Eigen::Vector2d in_shadow = side.project({0, 0, 0}), beside = side.project({40, 0, 0});
  CHECK(view.gray.at<std::uint8_t>(std::lround(in_shadow.y()), std::lround(in_shadow.x())) == 0);
  CHECK(view.gray.at<std::uint8_t>(std::lround(beside.y()), std::lround(beside.x())) ==
        Approx(50).margin(1));
}

TEST_CASE("a picture does not depend on the number of threads") {
  const Model frame = build_model(1, "frame", shapes::frame(60, 30, 20));
  World world = world_of(frame, {0, 0, 0});
  world.table = {true, {-200, -200}, {200, 200}, 0.5};
  world.lights.push_back({{300, -500, 800}, 60, 100, true});
  Sensor sensor;
  sensor.noise = 3;
  sensor.grain = 1;
  sensor.blur_px = 0.7;
  const Camera camera = camera_above(Camera::Projection::kPinhole);
  const RenderedView one = render_view(world, camera, sensor, 7, 1);
  const RenderedView three = render_view(world, camera, sensor, 7, 3);
  CHECK(disagreement(one.gray, three.gray) == 0);
  CHECK(disagreement(one.surfaces, three.surfaces) == 0);
  CHECK(disagreement(one.gray, render_view(world, camera, sensor, 8, 1).gray) > 0.5);
}

TEST_CASE("a camera without a size is refused") {
  const Model block = build_model(1, "block", shapes::block(40, 20, 10));
  Camera camera = camera_above(Camera::Projection::kPinhole);
  camera.width_px = 0;
  CHECK_THROWS_WITH(render_view(world_of(block, {0, 0, 0}), camera, {}, 1),
                    Catch::Contains("no image size"));
}
