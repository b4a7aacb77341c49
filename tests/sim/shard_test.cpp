// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <regex>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

TEST_CASE("merged shards of verify are what the whole regression gives") {
  const Scratch scratch;
  const auto report_of = [](const std::string& file) {
    return std::regex_replace(read_whole(file, "report"), std::regex("time=\"[^\"]*\""), "");
  };
  const auto verify = [&](const std::string& junit) {
    return "verify --frames 30 --seed 9 --junit " + (scratch / junit).string();
  };
  const std::string shards = (scratch / "shards").string();
  const Run whole = run_program(verify("whole.xml"));
  REQUIRE(whole.exit_code == 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Run part =
        run_program(verify("merged.xml") + " --results " + shards + " --shard " + shard);
    CHECK(part.exit_code == 0);
    CHECK_THAT(part.out, Contains(shard));
  }
  const Run merged = run_program("merge " + shards);
  CHECK(merged.exit_code == 0);
  CHECK(merged.out.substr(0, merged.out.rfind(',')) == whole.out.substr(0, whole.out.rfind(',')));
  CHECK(report_of((scratch / "merged.xml").string()) ==
        report_of((scratch / "whole.xml").string()));
}

TEST_CASE("merged shards of simulate write the same features and lines as the whole") {
  const Scratch scratch;
  std::filesystem::create_directory(scratch / "frames");
  const char* views[] = {"/gray/000000.png", "/gray/000001.png", "/gray/000002.png"};
  for (int i = 0; i < 33; ++i)  // two batches
    std::filesystem::create_symlink(kStudioScene + views[i % 3],
                                    scratch / ("frames/" + std::to_string(100 + i) + ".png"));
  const auto simulate = [&](const std::string& out) {
    return "simulate " + (scratch / "frames").string() + " --frontend golden --out " +
           (scratch / out).string();
  };
  const std::string shards = (scratch / "shards").string();
  const Run whole = run_program(simulate("whole"));
  REQUIRE(whole.exit_code == 0);
  for (const char* shard : {"1/2", "2/2"})
    CHECK(run_program(simulate("parts") + " --results " + shards + " --shard " + shard).exit_code ==
          0);
  const Run merged = run_program("merge " + shards);
  CHECK(merged.exit_code == 0);
  CHECK(merged.out.substr(0, merged.out.rfind(" in ")) ==
        whole.out.substr(0, whole.out.rfind(" in ")));
  CHECK_THAT(merged.out, Contains("\n33 frames, "));
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "whole/frames")) {
    ++files;
    CHECK(read_whole(entry.path(), "features") ==
          read_whole(scratch / "parts/frames" / entry.path().filename().string(), "features"));
  }
  CHECK(files == 66);
  const Run refused =
      run_program(simulate("x") + " --limit 3 --results " + shards + " --shard 1/2");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Contains("not with --limit"));
}
