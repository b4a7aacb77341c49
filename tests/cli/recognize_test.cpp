// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "cli/run.hpp"
#include "io/bop_results.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// A scene of three empty grey images with the cameras of a bundled one.
std::string empty_scene(const Scratch& scratch) {
  std::filesystem::create_directories(scratch / "000001/gray");
  std::filesystem::copy(kStudioScene + "/scene_camera.json", scratch / "000001");
  for (const char* name : {"000000.png", "000001.png", "000002.png"})
    cv::imwrite((scratch / "000001/gray" / name).string(), cv::Mat(300, 450, CV_8U, 120.0));
  return (scratch / "000001").string();
}

}  // namespace

TEST_CASE("a scene with nothing in it gives exit code 1 and an empty, valid result") {
  const Scratch scratch;
  const std::string scene = empty_scene(scratch), out = (scratch / "out").string();
  const Run run = run_program("recognize " + scene + " --models " + kModels + " --out " + out);
  CHECK(run.exit_code == 1);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("no object of the library found"));
  CHECK(read_results(out + "/results.csv").empty());
  CHECK(json::parse(read_whole(out + "/report.json", "report")).at("objects").empty());
}

TEST_CASE("recognize --out writes a picture of every stage and view") {
  const Scratch scratch;
  const std::string out = (scratch / "out").string();
  const Run run =
      run_program("recognize " + kStudioScene + " --models " + kModels + " --out " + out);
  CHECK(run.exit_code <= 1);
  for (const char* view : {"top", "side", "front"})
    for (const char* stage :
         {"gradient", "first_contour", "second_contour", "vertices", "regions", "models"}) {
      const cv::Mat picture = cv::imread(out + "/" + view + "_" + stage + ".png");
      INFO(view << " " << stage);
      CHECK(picture.size() == cv::Size(900, 600));
    }
  CHECK_FALSE(cv::imread(out + "/overview.png").empty());
}

TEST_CASE("recognize --json prints one document with every section") {
  const Run run = run_program("recognize " + kStudioScene + " --models " + kModels + " --json");
  CHECK(run.exit_code <= 1);
  const json report = json::parse(run.out);
  CHECK(report.at("scene") == "000034");
  for (const char* section : {"views", "objects", "rejections", "surfaces", "stages"})
    CHECK(report.at(section).is_array());
  CHECK((run.exit_code == 1) == report.at("objects").empty());
}

TEST_CASE("the report explains each object, each rejection and each stage") {
  const Run run = run_program("recognize " + kStudioScene + " --models " + kModels + " --json");
  const json report = json::parse(run.out);
  REQUIRE(report.at("objects").size() == 2);
  for (const json& object : report.at("objects")) {
    CHECK(object.at("covariance").size() == 36);
    CHECK(object.at("covariance")[0].get<double>() > 0);
    CHECK(object.at("reprojection_rms_px").get<double>() > 0);
    CHECK(object.contains("runner_up"));
    CHECK(object.at("surfaces").size() >= 3);
    for (const json& match : object.at("surfaces")) {
      const json& seen = report.at("surfaces").at(match.at("scene_surface").get<std::size_t>());
      CHECK(seen.at("view") == match.at("view"));
      CHECK(match.at("found_share").get<double>() <= 1);
    }
  }
  for (const json& rejection : report.at("rejections"))
    CHECK_FALSE(rejection.at("reason").get<std::string>().empty());
  REQUIRE(report.at("stages").size() == 4);
  for (const json& stage : report.at("stages")) CHECK(stage.at("count").get<int>() > 0);
}

TEST_CASE("a scene that cannot be read is named on one line with exit code 2") {
  const Scratch scratch;
  const std::string scene = empty_scene(scratch);
  const auto message = [&](const std::string& arguments) {
    const Run run = run_program("recognize " + arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
    return run.err;
  };
  CHECK_THAT(message("no/such/scene --models " + kModels),
             Contains("no/such/scene: no such folder"));
  CHECK_THAT(message(scene), Contains("--models: missing"));
  CHECK_THAT(message(scene + " --models no/models"), Contains("no/models: no such folder"));
  cv::imwrite(scene + "/gray/000001.png", cv::Mat(3, 450, CV_8U, 120.0));
  CHECK_THAT(message(scene + " --models " + kModels),
             Contains("gray/000001.png: the image is 450 x 3 px"));
  scratch.write("000001/gray/000001.png", "not an image, but long enough");
  CHECK_THAT(message(scene + " --models " + kModels), Contains("000001.png: not a readable image"));
  std::string png = read_whole(kStudioScene + "/gray/000001.png", "an image");
  png[png.size() / 2] ^= 1;  // libpng has words of its own for this
  scratch.write("000001/gray/000001.png", png);
  CHECK_THAT(message(scene + " --models " + kModels), Contains("000001.png: not a readable image"));
  scratch.write("000001/scene_camera.json", "{\"0\": [1, 2");
  CHECK_THAT(message(scene + " --models " + kModels),
             Contains("scene_camera.json: broken JSON: parse error at line 1"));
}

TEST_CASE("a folder named models near the scene is found without being asked for") {
  const Scratch scratch;
  const std::string scene = empty_scene(scratch);
  std::filesystem::copy(kModels, scratch / "models");
  CHECK(run_program("recognize " + scene).exit_code == 1);
}
