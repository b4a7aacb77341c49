// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/run.hpp"
#include "io/bop_results.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

TEST_CASE("evaluate lists every set, and the number of jobs changes nothing but times") {
  const Scratch scratch;
  std::string results[2], features[2];
  for (int jobs : {1, 3}) {
    const std::string name = std::to_string(jobs);
    const Run run = run_program("evaluate " + kScenes + " --models " + kModels + " --jobs " + name +
                                " --csv " + (scratch / name).string() + " --features " +
                                (scratch / ("features" + name)).string());
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());  // quiet: standard error is no terminal here
    CHECK_THAT(run.out, Contains("cad-isolated") && Contains("lab-hd-multi") && Contains("\nall "));
    results[jobs / 2] = without_times(read_whole(scratch / name, "results"));
    for (const char* file : {"/000060/000000.png", "/000060/000000.csv", "/000034/000002.csv"})
      features[jobs / 2] += read_whole((scratch / ("features" + name)).string() + file, "features");
  }
  CHECK(results[0] == results[1]);
  CHECK(features[0] == features[1]);
}

TEST_CASE("evaluate --json gives the same figures for machines") {
  const Run run = run_program("evaluate " + kScenes + "/cad-two --models " + kModels + " --json");
  CHECK(run.exit_code == 0);
  const auto figures = nlohmann::json::parse(run.out);
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].at("set") == "cad-multi");
  CHECK(figures[1].at("set") == "all");
  CHECK(figures[1].at("objects") == 2);
}

TEST_CASE("evaluate names what is wrong on one line with exit code 2") {
  const Scratch scratch;
  const auto message = [&](const std::string& arguments) {
    const Run run = run_program("evaluate --models " + kModels + " " + arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    return run.err;
  };
  CHECK_THAT(message(scratch.path().string()), Contains("no scenes in this folder"));
  CHECK_THAT(message(kScenes + " --csv " + (scratch / "none/x.csv").string()),
             Contains("none: no such folder; expected a folder for --csv"));
  // A broken scene is found by whichever worker gets it.
  std::filesystem::copy(kScenes + "/cad-two", scratch / "set",
                        std::filesystem::copy_options::recursive);
  std::filesystem::copy(scratch / "set/000017", scratch / "set/000018",
                        std::filesystem::copy_options::recursive);
  std::filesystem::remove(scratch / "set/000018/gray/000002.png");
  for (const char* jobs : {"1", "2"}) {
    const std::string csv = (scratch / "r.csv").string();
    CHECK_THAT(message((scratch / "set").string() + " --jobs " + jobs + " --csv " + csv),
               Contains("000018/gray/000002.png: no such file"));
    CHECK_FALSE(std::filesystem::exists(csv));
  }
}
