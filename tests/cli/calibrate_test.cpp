// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/run.hpp"
#include "io/scene_cameras.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

const std::string kImages = "/usr/share/doc/opencv-doc/examples/data/";  // Debian's opencv-doc

}  // namespace

TEST_CASE("calibrate makes a scene_camera.json of OpenCV's stereo pictures") {
  if (!std::filesystem::exists(kImages + "left01.jpg")) {
    WARN("opencv-doc is not installed: not tried on its stereo pictures");
    return;
  }
  const Scratch scratch;
  const std::string out = (scratch / "scene_camera.json").string();
  const Run run = run_program("calibrate '" + kImages + "left*.jpg' '" + kImages +
                              "right*.jpg' --board 9x6 --square 25 --table 01 --out " + out);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("13 of 13") && Contains("written: "));
  const std::vector<ViewCamera> views = read_cameras(out);
  REQUIRE(views.size() == 2);
  CHECK(views[0].camera.view == "left");
  const Eigen::Vector3d baseline =
      views[1].camera.camera_from_world.inverse().t - views[0].camera.camera_from_world.inverse().t;
  // Two cameras on one bar, 83 mm apart where squares are 25 mm wide (OpenCV's own sample finds
  // 3.33 squares), 640 x 480 px, focal length about 535 px.
  CHECK(baseline.norm() == Approx(83.2).margin(0.5));
  for (const ViewCamera& view : views) CHECK(view.camera.K(0, 0) == Approx(535).margin(5));
  // The table's z points at the cameras.
  CHECK(views[0].camera.camera_from_world.inverse().t.z() > 200);
  const Run rig = run_program("rig " + out + " --json");
  CHECK(rig.exit_code == 0);
  CHECK(nlohmann::json::parse(rig.out).at("points").size() == 9);
}

TEST_CASE("calibrate names what is wrong on one line with exit code 2") {
  const Scratch scratch;
  const auto message = [&](const std::string& arguments) {
    const Run run = run_program("calibrate " + arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
    return run.err;
  };
  std::filesystem::create_directories(scratch / "empty");
  const std::string empty = (scratch / "empty").string(), gray = kStudioScene + "/gray";
  const std::string board = " --board 9x6 --square 20";
  CHECK_THAT(message(empty + " " + empty + board), Contains("empty: no image"));
  CHECK_THAT(message("none none" + board), Contains("none: no such folder"));
  CHECK_THAT(message("'" + empty + "/top*.png' x" + board), Contains("top*.png: no image"));
  CHECK_THAT(message(gray + " " + gray + board), Contains("two cameras are named gray"));
  std::filesystem::copy(gray, scratch / "copy");
  CHECK_THAT(message(gray + " " + (scratch / "copy").string() + board),
             Contains("camera gray: 0 boards found in 3 images (none in 000000.png, 000001.png"));
  CHECK_THAT(message(gray + " x --board 8x6 --square 20"), Contains("half turn"));
  CHECK_THAT(message(gray + " x --board 9x6 --square -1"), Contains("--square"));
}

TEST_CASE("rig tells what a set of cameras allows") {
  const Run run = run_program("rig " + kStudioScene + "/scene_camera.json --noise 0.2");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("mm per px") && Contains("widest angle"));
  const Run blind = run_program("rig " + kStudioScene + "/scene_camera.json --centre 5000 0 0");
  CHECK(blind.exit_code == 1);
  CHECK_THAT(blind.out, Contains("seen by fewer than two cameras"));
}
