// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "io/bop_results.hpp"
#include "io/feature_files.hpp"
#include "io/file.hpp"
#include "io/views.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

TEST_CASE("results written and read again are the same") {
  const Scratch scratch;
  ResultRow row{34, 0, 7, 0.875, {}, 0.25};
  row.camera_from_model.R =
      Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  row.camera_from_model.t = {-12.5, 33.25, 601.125};
  write_whole(scratch / "r.csv", format_results({row, row}));
  const std::vector<ResultRow> read = read_results(scratch / "r.csv");
  REQUIRE(read.size() == 2);
  CHECK(read[1].scene_id == 34);
  CHECK(read[1].model_id == 7);
  CHECK(read[1].score == 0.875);
  CHECK(read[1].seconds == 0.25);
  constexpr double kDigits = 1e-9;
  CHECK((read[1].camera_from_model.R - row.camera_from_model.R).norm() < 10 * kDigits);
  CHECK((read[1].camera_from_model.t - row.camera_from_model.t).norm() < kDigits);
}

TEST_CASE("result poses are in the frame of the first view's camera") {
  const Scene scene = read_scene(TRIHEDRON_TESTVECTORS "/scenes/studio-two/000034");
  RecognitionResult result;
  for (const TrueObject& object : *scene.truth) {
    RecognizedObject found;
    found.model_id = object.model_id;
    found.world_from_model = object.world_from_model;
    result.objects.push_back(found);
  }
  const std::vector<ResultRow> rows = result_rows(scene, result, 1);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].im_id == 0);
  // cam_t_m2c of view 0 in the scene's truth lies 0.6 m in front of the camera.
  CHECK(rows[0].camera_from_model.t.z() == Approx(600).margin(60));
}

TEST_CASE("broken results are named with line and field") {
  const Scratch scratch;
  const std::string header = "scene_id,im_id,obj_id,score,R,t,time\n";
  const auto message = [&](const std::string& text) {
    scratch.write("r.csv", text);
    return error_of([&] { read_results(scratch / "r.csv"); });
  };
  CHECK_THAT(message("a,b\n"), Contains("r.csv: line 1: header: expected scene_id,"));
  CHECK_THAT(message(header + "1,0,7,0.5,1 0 0 0 1 0 0 0 1,1 2 3\n"),
             Contains("line 2: 6 fields; expected 7"));
  CHECK_THAT(message(header + "1,0,3e9,0.5,1 0 0 0 1 0 0 0 1,1 2 3,1\n"),
             Contains("line 2: obj_id: expected an integer from 0"));
  CHECK_THAT(message(header + "1,0,7,0.5,1 0 0 0 1 0 0 0,1 2 3,1\n"),
             Contains("line 2: R: expected 9 numbers"));
  CHECK_THAT(message(header + "1,0,x,0.5,1 0 0 0 1 0 0 0 1,1 2 3,1\n"),
             Contains("line 2: obj_id: expected 1 number"));
  CHECK_THAT(message(header + "1,0,7,0.5,1 0 0 0 1 0 0 0 1,1 nan 3,1\n"),
             Contains("line 2: t: expected finite numbers"));
}

TEST_CASE("feature files hold the contour mask and the vertices") {
  const Scratch scratch;
  ViewFeatures features;
  features.width = 7;
  features.height = 6;
  features.contour.resize(42);
  features.contour[2 * 7 + 3].flags = kContour | kFirstContour;
  features.contour[2 * 7 + 4].flags = kFirstContour;
  features.vertices.push_back({3, 2, 4, 11, 99});
  write_features(scratch / "000012", 1, features);
  const cv::Mat mask = cv::imread((scratch / "000012/000001.png").string(), cv::IMREAD_UNCHANGED);
  CHECK(mask.size() == cv::Size(7, 6));
  CHECK(cv::countNonZero(mask) == 1);
  CHECK(mask.at<unsigned char>(2, 3) == 255);
  const std::string csv = read_whole(scratch / "000012/000001.csv", "vertices");
  CHECK(csv.rfind("x,y,", 0) == 0);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 2);
  CHECK_THAT(csv, Contains("\n3,2,"));
}

TEST_CASE("writing into a folder that is a file is refused and leaves nothing behind") {
  const Scratch scratch;
  scratch.write("file", "x");
  CHECK_THAT(error_of([&] { make_folder(scratch / "file"); }), Contains("cannot make this folder"));
  CHECK_THAT(error_of([&] { write_whole(scratch / "none/x", "x"); }),
             Contains("cannot be written"));
  CHECK(std::distance(std::filesystem::directory_iterator(scratch.path()), {}) == 1);
}

TEST_CASE("the golden front end gives every view its features") {
  const Scene scene = read_scene(TRIHEDRON_TESTVECTORS "/scenes/cad-isolated/000001");
  const std::vector<View> views = make_views(scene, golden_front_end());
  REQUIRE(views.size() == 3);
  for (const View& view : views) {
    CHECK(view.features.width == view.camera.width_px);
    CHECK(view.features.height == view.camera.height_px);
    CHECK(view.features.contour.size() == 450u * 300u);
    CHECK_FALSE(view.features.vertices.empty());
  }
}
