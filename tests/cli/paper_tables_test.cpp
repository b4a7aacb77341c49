// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

const std::string kCadTwo = kScenes + "/cad-two/000017";

}  // namespace

TEST_CASE("recognize --method paper --tables prints the paper's tables") {
  const Run run =
      run_program("recognize " + kCadTwo + " --models " + kModels + " --method paper --tables");
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  for (const char* part : {"Table 1.", "Table 2.", "Tables 3, 4.", "Tables 5, 6.", "l1 ", "(1;",
                           "model 5", "model 1 ", "d = "})
    CHECK_THAT(run.out, Contains(part));
}

TEST_CASE("evaluate --tables prints them for every scene, however many workers") {
  const std::string command =
      "evaluate " + kScenes + "/cad-isolated --models " + kModels + " --method paper --tables";
  const Run one = run_program(command), two = run_program(command + " --jobs 2");
  CHECK(one.exit_code == 0);
  CHECK_THAT(one.out, Contains("scene 000001") && Contains("scene 000009"));
  CHECK_THAT(two.out, Contains("scene 000001") && Contains("scene 000009"));
}

TEST_CASE("tables of method full are refused") {
  const Run run = run_program("recognize " + kCadTwo + " --models " + kModels + " --tables");
  CHECK(run.exit_code == 2);
  CHECK(is_one_line(run.err));
  CHECK_THAT(run.err, Contains("--method paper"));
}
