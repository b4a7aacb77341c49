// SPDX-License-Identifier: Apache-2.0
// Programs that are killed (SIGKILL: no handler helps) must leave nothing that looks whole and is
// not.
#include <catch2/catch.hpp>

#include "cli/run.hpp"
#include "io/scene.hpp"

using namespace trihedron;
namespace fs = std::filesystem;

namespace {

/// Starts the program, kills it as soon as `pattern` (of the shell) names a file; whether it was
/// killed before it was done.
bool kill_when_there(const Scratch& scratch, const std::string& arguments,
                     const std::string& pattern) {
  scratch.write("kill.sh", std::string(TRIHEDRON_BINARY) + " " + arguments +
                               " >/dev/null & program=$!\nuntil compgen -G '" + pattern +
                               "' >/dev/null; do kill -0 $program || exit 3; done\n"
                               "kill -KILL $program; wait $program; test $? = 137\n");
  return std::system(("bash " + (scratch / "kill.sh").string() + " 2>/dev/null").c_str()) == 0;
}

}  // namespace

TEST_CASE("a rendering that is killed leaves whole scenes only, and goes on over the rest") {
  const Scratch scratch;
  const std::string set = (scratch / "set").string();
  const std::string command = "render " + set + " --models " + kModels + " --look cad --seed 3 ";
  REQUIRE(kill_when_there(scratch, command + "--scenes 200", set + "/000002/gray/000001.png"));
  int whole = 0;
  for (const fs::path& folder : find_scenes(set)) {  // those with scene_camera.json
    const Scene scene = read_scene(folder);
    CHECK(scene.images.size() == 3);
    CHECK(scene.truth.has_value());
    ++whole;
  }
  CHECK(whole >= 1);
  CHECK(run_program(command + "--scenes 2 --quiet").exit_code == 0);
  CHECK(find_scenes(set).size() >= 2);
}

TEST_CASE("a simulation that is killed leaves whole feature files only") {
  const Scratch scratch;
  const std::string out = (scratch / "features").string();
  std::string inputs;
  for (int i = 0; i < 60; ++i) inputs += " " + kStudioScene;
  REQUIRE(kill_when_there(scratch, "simulate" + inputs + " --frontend golden --out " + out,
                          out + "/000034/000001.csv"));
  const Run whole = run_program("simulate " + kStudioScene + " --frontend golden --quiet --out " +
                                (scratch / "whole").string());
  REQUIRE(whole.exit_code == 0);
  int files = 0;
  for (const auto& entry : fs::directory_iterator(out + "/000034")) {
    const std::string name = entry.path().filename().string();
    if (name.find(".part") != std::string::npos) continue;  // not under its name yet
    ++files;
    CHECK(read_whole(entry.path(), "features") ==
          read_whole(scratch / "whole/000034" / name, "features"));
  }
  CHECK(files >= 1);
}
