// SPDX-License-Identifier: Apache-2.0
// The project's main job on the bundled scenes, from pixels through the simulated RTL to poses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/run.hpp"

using namespace trihedron;

namespace {

/// The design's bound on the median vertex error of noisy scenes, mm.
constexpr double kMedianVertexErrorMm = 0.6;

}  // namespace

TEST_CASE("every object of the bundled scenes is recognised from the simulated RTL, and no other") {
  const Run run = run_program("evaluate " + kScenes + " --models " + kModels + " --json --jobs 2");
  CHECK(run.exit_code == 0);
  const auto figures = nlohmann::json::parse(run.out);
  REQUIRE(figures.size() == 9);
  for (const auto& set : figures) {
    INFO(set.at("set"));
    CHECK(set.at("right") == set.at("objects"));
    CHECK(set.at("wrong") == 0);
    CHECK(set.at("vertex_median_mm").get<double>() < kMedianVertexErrorMm);
  }
  CHECK(figures.back().at("scenes") == 10);
  CHECK(figures.back().at("objects") == 19);
}

TEST_CASE("the simulated RTL and the golden model lead to the same features and the same poses") {
  const Scratch scratch;
  std::string results[2], features[2];
  const std::string front_ends[2] = {"rtl", "golden"};
  for (int i : {0, 1}) {
    const std::string csv = (scratch / (front_ends[i] + ".csv")).string();
    const std::string folder = (scratch / front_ends[i]).string();
    const Run run =
        run_program("evaluate " + kScenes + "/lab-stacked --models " + kModels + " --frontend " +
                    front_ends[i] + " --csv " + csv + " --features " + folder);
    REQUIRE(run.exit_code == 0);
    results[i] = without_times(read_whole(csv, "results"));
    for (const char* view : {"/000056/000000", "/000056/000001", "/000056/000002"})
      for (const char* end : {".png", ".csv"})
        features[i] += read_whole(folder + view + end, "features");
  }
  CHECK(results[0] == results[1]);
  CHECK(features[0] == features[1]);
}
