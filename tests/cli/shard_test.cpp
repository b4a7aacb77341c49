// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// The evaluation's table without the one of times behind it.
std::string figures(const std::string& table) {
  return table.substr(0, table.find("ms per scene"));
}

std::string evaluation(const Scratch& scratch, const std::string& csv) {
  return "evaluate " + kScenes + "/cad-isolated --models " + kModels + " --frontend golden --csv " +
         (scratch / csv).string();
}

}  // namespace

TEST_CASE("merged shards of evaluate are what the whole evaluation gives") {
  const Scratch scratch;
  const std::string shards = (scratch / "shards").string();
  const Run whole = run_program(evaluation(scratch, "whole.csv"));
  REQUIRE(whole.exit_code == 0);
  const std::string sharded = evaluation(scratch, "merged.csv") + " --results " + shards;
  CHECK(run_program(sharded + " --shard 2/2 --jobs 2").exit_code == 0);
  const Run early = run_program("merge " + shards);
  CHECK(early.exit_code == 2);
  CHECK_THAT(early.err, Contains("not finished: 1/2"));
  CHECK(is_one_line(early.err));
  CHECK(run_program(sharded + " --shard 1/2").exit_code == 0);
  CHECK_FALSE(fs::exists(scratch / "merged.csv"));
  const Run merged = run_program("merge " + shards);
  CHECK(merged.exit_code == 0);
  CHECK(merged.err.empty());
  CHECK(figures(merged.out) == figures(whole.out));
  CHECK(without_times(read_whole(scratch / "merged.csv", "csv")) ==
        without_times(read_whole(scratch / "whole.csv", "csv")));
}

TEST_CASE("a finished shard is not run again, and another job's shard is refused") {
  const Scratch scratch;
  const std::string shards = (scratch / "shards").string();
  const std::string sharded = evaluation(scratch, "a.csv") + " --shard 1/2 --results " + shards;
  REQUIRE(run_program(sharded).exit_code == 0);
  const fs::path file = shards + "/shard-000001-of-000002.jsonl";
  const std::string before = read_whole(file, "shard");
  const Run again = run_program(sharded);
  CHECK(again.exit_code == 0);
  CHECK_THAT(again.out, Contains("done before"));
  CHECK(read_whole(file, "shard") == before);  // times and all
  const Run other = run_program(sharded + " --method paper");
  CHECK(other.exit_code == 2);
  CHECK_THAT(other.err, Contains("another command line"));
  CHECK(is_one_line(other.err));
}

TEST_CASE("what is no shard is refused on one line") {
  const Scratch scratch;
  const std::string folder = (scratch / "shards").string();
  const auto message = [&](const std::string& arguments) {
    const Run run = run_program(arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    return run.err;
  };
  const std::string evaluate = evaluation(scratch, "a.csv");
  for (const char* bad : {"0/2", "3/2", "2", "a/b", "1/2x"})
    CHECK_THAT(message(evaluate + " --results " + folder + " --shard " + bad),
               Contains("I/N with I from 1 to N"));
  CHECK_THAT(message(evaluate + " --shard 1/2"), Contains("--results"));
  CHECK_THAT(message(evaluate + " --results " + folder), Contains("needs --shard"));
  CHECK_THAT(message("merge " + folder), Contains("no such folder"));
  fs::create_directory(folder);
  CHECK_THAT(message("merge " + folder), Contains("no shard in this folder"));
  scratch.write("shards/shard-000001-of-000001.jsonl", "{\"half");
  CHECK_THAT(message("merge " + folder), Contains("damaged"));
}

TEST_CASE("a shard of which a byte changed, or whose end is missing, is refused on one line") {
  const Scratch scratch;
  const std::string folder = (scratch / "shards").string();
  REQUIRE(run_program(evaluation(scratch, "a.csv") + " --results " + folder + " --shard 1/1")
              .exit_code == 0);
  const fs::path file = fs::path(folder) / "shard-000001-of-000001.jsonl";
  const std::string whole = read_whole(file.string(), "a shard");
  std::vector<std::string> damaged = {"", whole.substr(0, whole.size() - 1),
                                      whole.substr(0, whole.rfind("{\"crc32")), whole + "{}\n"};
  for (const char* word : {"\"item\":0", "\"item\":1", "command_line", "\"text\""}) {
    damaged.push_back(whole);
    REQUIRE(whole.find(word) != std::string::npos);
    damaged.back()[whole.find(word) + std::string(word).size() - 1] = '7';
  }
  for (const std::string& bytes : damaged) {
    scratch.write("shards/" + file.filename().string(), bytes);
    const Run run = run_program("merge " + folder);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK_THAT(run.err, Contains(file.string()) && Contains("damaged"));
  }
}

TEST_CASE("an evaluation that is killed leaves no results, and its shard runs again") {
  const Scratch scratch;
  const std::string shards = (scratch / "shards").string();
  const std::string csv = (scratch / "killed.csv").string();
  // All bundled scenes take seconds; the signal comes once the features of the first are written.
  const std::string features = (scratch / "features").string();
  const std::string command = "evaluate " + kScenes + " --models " + kModels + " --jobs 2 --csv " +
                              csv + " --features " + features;
  for (const std::string& part : {std::string(), " --shard 1/1 --results " + shards}) {
    scratch.write("kill.sh", std::string(TRIHEDRON_BINARY) + " " + command + part +
                                 " & program=$!\nuntil ls " + features +
                                 "/*/*.png >/dev/null 2>&1; do kill -0 $program || exit 3; done\n" +
                                 "kill -KILL $program\nwait $program 2>/dev/null; test $? = 137");
    CHECK(std::system(("bash " + (scratch / "kill.sh").string() + " 2>/dev/null").c_str()) == 0);
    CHECK_FALSE(fs::exists(csv));
    CHECK_FALSE(fs::exists(shards + "/shard-000001-of-000001.jsonl"));
    fs::remove_all(features);
  }
}
