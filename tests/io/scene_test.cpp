// SPDX-License-Identifier: Apache-2.0
#include "io/scene.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "io/json_field.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using nlohmann::json;

namespace {

const std::string kScene = TRIHEDRON_TESTVECTORS "/scenes/studio-two/000034";

/// A copy of a bundled scene that a test may break.
struct Broken {
  Scratch scratch;
  std::filesystem::path folder = scratch / "000034";

  Broken() { std::filesystem::copy(kScene, folder, std::filesystem::copy_options::recursive); }

  /// Changes one entry of scene_camera.json.
  void camera(const std::string& view, const std::string& key, const json& value) {
    json document = read_json(folder / "scene_camera.json");
    document[view][key] = value;
    scratch.write("000034/scene_camera.json", document.dump());
  }
  void image(const std::string& view, int width, int height) {
    cv::imwrite((folder / "gray" / (view + ".png")).string(), cv::Mat(height, width, CV_8U, 90.0));
  }
  std::string message() const {
    return error_of([&] { read_scene(folder); });
  }
};

}  // namespace

TEST_CASE("a scene folder gives cameras, images and truth") {
  const Scene scene = read_scene(kScene);
  CHECK(scene.id == 34);
  CHECK(scene.name == "000034");
  CHECK(scene.kind == "studio-multi");
  REQUIRE(scene.cameras.size() == 3);
  CHECK(scene.cameras[0].view == "top");
  CHECK(scene.cameras[2].view == "front");
  CHECK(scene.images[1].size() == cv::Size(450, 300));
  CHECK(scene.images[1].type() == CV_8UC1);
  CHECK(scene.cameras[1].width_px == 450);
  CHECK(scene.cameras[0].projection == Camera::Projection::kPinhole);
  REQUIRE(scene.truth);
  CHECK(scene.truth->size() == 2);
}

TEST_CASE("true poses agree between the views of every bundled scene") {
  for (const auto& folder : find_scenes(TRIHEDRON_TESTVECTORS "/scenes")) {
    const Scene scene = read_scene(folder);
    const json truth = read_json(folder / "scene_gt.json");
    for (std::size_t i = 0; i < scene.truth->size(); ++i) {
      const auto& entry = truth.at("2").at(i);
      const Transform expected =
          scene.cameras[2].camera_from_world * (*scene.truth)[i].world_from_model;
      CHECK((*scene.truth)[i].model_id == entry.at("obj_id").get<int>());
      constexpr double kDigitsMm = 1e-3;  // files hold nine digits of rotations times 1 m
      for (int k = 0; k < 3; ++k)
        CHECK(expected.t[k] == Approx(entry.at("cam_t_m2c").at(k).get<double>()).margin(kDigitsMm));
    }
  }
}

TEST_CASE("an orthographic scene carries its scale") {
  const Scene scene = read_scene(TRIHEDRON_TESTVECTORS "/scenes/cad-isolated/000001");
  CHECK(scene.cameras[0].projection == Camera::Projection::kOrthographic);
  CHECK(scene.cameras[0].px_per_mm == Approx(2.04733).epsilon(1e-4));
  CHECK(scene.kind == "cad-isolated");
}

TEST_CASE("a trailing slash does not change a scene's name") {
  CHECK(read_scene(kScene + "/").id == 34);
}

TEST_CASE("a lens and a stated size are read") {
  Broken scene;
  scene.camera("1", "cam_dist", {0.1, 0.2, 0.3, 0.4, 0.5});
  scene.camera("1", "width", 450);
  scene.camera("1", "height", 300);
  const Scene read = read_scene(scene.folder);
  CHECK(read.cameras[1].distortion == std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0.5});
}

TEST_CASE("rotations written with few digits become exact rotations") {
  const Scene scene = read_scene(kScene);
  for (const Camera& camera : scene.cameras) {
    const Eigen::Matrix3d& R = camera.camera_from_world.R;
    CHECK((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(R.determinant() == Approx(1));
  }
}

TEST_CASE("scenes are found in name order, two levels deep, or the folder itself") {
  const auto all = find_scenes(TRIHEDRON_TESTVECTORS "/scenes");
  CHECK(all.size() == 10);
  CHECK(std::is_sorted(all.begin(), all.end()));
  CHECK(find_scenes(kScene).size() == 1);
}

TEST_CASE("missing folders, empty folders and missing files are named") {
  const Scratch scratch;
  CHECK_THAT(error_of([&] { find_scenes(scratch.path()); }), Contains("no scenes in this folder"));
  CHECK_THAT(error_of([&] { find_scenes(scratch / "none"); }), Contains("none: no such folder"));
  CHECK_THAT(error_of([&] { read_scene(scratch / "none"); }), Contains("none: no such folder"));
  CHECK_THAT(error_of([&] { read_scene(scratch.path()); }),
             Contains("scene_camera.json: no such file"));
  Broken scene;
  std::filesystem::remove(scene.folder / "gray/000001.png");
  CHECK_THAT(scene.message(), Contains("gray/000001.png: no such file; expected an image"));
}

TEST_CASE("broken images are named") {
  Broken scene;
  scene.scratch.write("000034/gray/000002.png", "this is not an image at all");
  CHECK_THAT(scene.message(), Contains("gray/000002.png: not a readable image"));
  scene.scratch.write("000034/gray/000002.png", "");
  CHECK_THAT(scene.message(), Contains("gray/000002.png: not an image"));
  const std::string whole = (kScene + "/gray/000000.png");
  std::filesystem::copy(whole, scene.folder / "gray/000002.png",
                        std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(scene.folder / "gray/000002.png",
                               std::filesystem::file_size(whole) / 2);
  CHECK_THAT(scene.message(), Contains("gray/000002.png: the image is cut off"));
  for (const double part : {0.98, 0.3}) {  // the decoder takes what is there
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", cv::imread(whole, cv::IMREAD_GRAYSCALE), jpeg);
    const auto bytes = static_cast<std::size_t>(part * static_cast<double>(jpeg.size()));
    scene.scratch.write("000034/gray/000002.png", {jpeg.begin(), jpeg.begin() + bytes});
    CHECK_THAT(scene.message(), Contains("gray/000002.png: the image is cut off"));
  }
  scene.image("000002", 4, 300);
  CHECK_THAT(scene.message(), Contains("000002.png: the image is 4 x 300 px; expected sides of 5"));
}

TEST_CASE("image sizes that do not fit the camera or each other are named") {
  Broken scene;
  scene.image("000001", 900, 600);
  CHECK_THAT(scene.message(), Contains("scene_camera.json: 1: its image is 900 x 600 px, but that "
                                       "of view 0 is 450 x 300 px"));
  scene.image("000001", 225, 150);
  CHECK_THAT(scene.message(),
             Contains("scene_camera.json: 1.cam_K: the principal point (224.5, 149.5)"));
  Broken stated;
  stated.camera("0", "width", 640);
  stated.camera("0", "height", 480);
  CHECK_THAT(stated.message(), Contains("scene_camera.json: 0: width and height say 640 x 480 px"));
}

TEST_CASE("views may differ in size when the camera file says so") {
  Broken scene;
  scene.image("000001", 900, 600);
  for (const char* view : {"0", "1"}) {
    scene.camera(view, "width", view[0] == '1' ? 900 : 450);
    scene.camera(view, "height", view[0] == '1' ? 600 : 300);
  }
  CHECK(read_scene(scene.folder).cameras[1].width_px == 900);
}

TEST_CASE("broken camera files are named with file and field") {
  Broken scene;
  scene.scratch.write("000034/scene_camera.json", "{\"0\": {\"cam_K\": [1, 2,\n 3}}");
  CHECK_THAT(scene.message(), Contains("scene_camera.json: broken JSON: parse error at line 2"));
  scene.scratch.write("000034/scene_camera.json", "{\"0\": {}}");
  CHECK_THAT(scene.message(), EndsWith("scene_camera.json: holds 1 views; expected at least 2"));
  scene.scratch.write("000034/scene_camera.json", "[]");
  CHECK_THAT(scene.message(), EndsWith("scene_camera.json: expected an object"));
  scene.scratch.write("000034/scene_camera.json", "{\"top\": {}}");
  CHECK_THAT(scene.message(), Contains("\"top\" is not a view number"));
  scene.scratch.write("000034/scene_camera.json", "{\"0\": {}, \"1\": {}}");
  CHECK_THAT(scene.message(), EndsWith("scene_camera.json: 0.cam_K is missing"));
}

TEST_CASE("degenerate cameras are named with file and field") {
  const json mirror = {1, 0, 0, 0, 1, 0, 0, 0, -1}, squeezed = {1, 0, 0, 0, 1, 0, 0, 0, 0.9};
  const struct {
    const char* key;
    json value;
    const char* says;
  } cases[] = {
      {"cam_K", {0, 0, 224, 0, 1228, 149, 0, 0, 1}, "1.cam_K: expected fx s cx 0 fy cy 0 0 1"},
      {"cam_K", {1228, 0, 224, 0, 1228, 149, 0, 0}, "1.cam_K: expected a list of 9 numbers"},
      {"cam_K",
       {1228, 0, 224, 0, "a", 149, 0, 0, 1},
       "1.cam_K[4]: expected a number, found string"},
      {"cam_K",
       {nullptr, 0, 224, 0, 1228, 149, 0, 0, 1},
       "1.cam_K[0]: expected a number, found null"},
      {"cam_R_w2c", mirror, "1.cam_R_w2c: not a rotation"},
      {"cam_R_w2c", squeezed, "1.cam_R_w2c: not a rotation"},
      {"cam_t_w2c", {1, 2}, "1.cam_t_w2c: expected a list of 3 numbers"},
      {"cam_dist", {1, 2}, "1.cam_dist: expected a list of 5 numbers"},
      {"cam_model", "fisheye", "1.cam_model: unknown model \"fisheye\""},
      {"cam_model", "orthographic", "1.px_per_mm is missing"},
  };
  for (const auto& c : cases) {
    Broken scene;
    scene.camera("1", c.key, c.value);
    CHECK_THAT(scene.message(), Contains(std::string("scene_camera.json: ") + c.says));
  }
  Broken scene;
  scene.scratch.write("000034/scene_camera.json", "{\"0\": {\"cam_K\": [NaN]}}");
  CHECK_THAT(scene.message(), Contains("broken JSON: parse error at line 1"));
  scene.scratch.write("000034/scene_camera.json", "{\"0\": {\"cam_K\": [1e999]}}");
  CHECK_THAT(scene.message(), Contains("broken JSON: number overflow"));
}

TEST_CASE("broken truth is named with file and field") {
  Broken scene;
  scene.scratch.write("000034/scene_gt.json", "{\"0\": [{\"obj_id\": 1.5}]}");
  CHECK_THAT(scene.message(), EndsWith("scene_gt.json: 0[0].cam_R_m2c is missing"));
  scene.scratch.write("000034/scene_gt.json", "{\"7\": []}");
  CHECK_THAT(scene.message(), Contains("holds none of the views"));
  std::filesystem::remove(scene.folder / "scene_gt.json");
  CHECK_FALSE(read_scene(scene.folder).truth);
}
