// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("help and version are answers, not errors") {
  for (const char* command : {"", "recognize ", "evaluate ", "models "}) {
    const Run run = run_program(std::string(command) + "--help");
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.out, Contains("Example"));
    CHECK(run.err.empty());
  }
  const Run version = run_program("--version");
  CHECK(version.exit_code == 0);
  CHECK_THAT(version.out, StartsWith("trihedron 0."));
}

TEST_CASE("wrong usage is one line and exit code 2") {
  const struct {
    std::string arguments, says;
  } cases[] = {
      {"", "trihedron: no command given; expected recognize, "},
      {"recognise x", "trihedron: unknown command recognise; expected recognize, "},
      {"recognize", "SCENE is required"},
      {"recognize x --colour", "--colour"},
      {"recognize x --frontend fpga", "--frontend: fpga not in"},
      {"recognize x --method best", "--method: best not in"},
      {"evaluate x --jobs 0", "--jobs: "},
      {"evaluate x --jobs many", "--jobs"},
      {"models", "DIR is required"},
  };
  for (const auto& c : cases) {
    const Run run = run_program(c.arguments);
    INFO(c.arguments);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains(c.says));
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
  }
}

TEST_CASE("models lists the library, for people and for machines") {
  const Run run = run_program("models " + kModels);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("gable_block") && Contains("u_channel"));
  CHECK(run.err.empty());
  CHECK_THAT(run_program("models --surfaces " + kModels).out, Contains("centroid ("));
  CHECK_THAT(run_program("models --json " + kModels).out, StartsWith("["));
}

TEST_CASE("models that cannot be used are named with exit code 2") {
  const Scratch scratch;
  const Run empty = run_program("models " + scratch.path().string());
  CHECK(empty.exit_code == 2);
  CHECK_THAT(empty.err, Contains("no meshes in this folder"));
  scratch.write("obj_000001.off", "OFF\n3 1 0\n0 0 0\n50 0 0\n0 50 0\n3 0 1 2\n");
  const Run open = run_program("models " + scratch.path().string());
  CHECK(open.exit_code == 2);
  CHECK_THAT(open.err, Contains("obj_000001.off: not closed: the edge from"));
  CHECK(is_one_line(open.err));
}
