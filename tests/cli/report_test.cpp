// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

const std::string kOptions = " --models " + kModels + " --frontend golden";

}  // namespace

TEST_CASE("a report that cannot be written is refused before the work, on one line") {
  const Scratch scratch;
  for (const std::string& command : {"recognize " + kStudioScene, "evaluate " + kStudioScene}) {
    const Run missing = run_program(command + kOptions + " --report " + scratch.path().string() +
                                    "/no/such/report.html");
    CHECK(missing.exit_code == 2);
    CHECK(is_one_line(missing.err));
    CHECK(missing.out.empty());
    CHECK_THAT(missing.err, Contains("no/such: no such folder; expected a folder for --report"));
    const Run folder = run_program(command + kOptions + " --report " + scratch.path().string());
    CHECK(folder.exit_code == 2);
    CHECK_THAT(folder.err, Contains("--report is a folder; expected a file name"));
  }
}

TEST_CASE("a scene that is not in the data set cannot be chosen for a report") {
  const Scratch scratch;
  const Run run = run_program("evaluate " + kStudioScene + kOptions + " --report " +
                              (scratch / "r.html").string() + " --report-scenes 000099");
  CHECK(run.exit_code == 2);
  CHECK(is_one_line(run.err));
  CHECK_THAT(run.err, Contains("--report-scenes 000099: no such scene in the data set"));
}

TEST_CASE("evaluate writes the same report whatever the number of jobs, times aside") {
  const Scratch scratch;
  const auto page = [&](const std::string& jobs) {
    const std::string file = (scratch / ("r" + jobs + ".html")).string();
    const Run run = run_program("evaluate " + kScenes + "/studio-two" + kOptions + " --report " +
                                file + " --report-scenes all --jobs " + jobs);
    CHECK(run.exit_code == 0);
    const std::regex times("\"(seconds|milliseconds)\":[0-9.e+-]+");
    std::string text = read_whole(file, "a report");
    text = text.substr(text.find("id=\"data\""),
                       text.find("</script", text.find("id=\"data\"")) - text.find("id=\"data\""));
    return std::regex_replace(text, times, "\"$1\":0");
  };
  CHECK(page("1") == page("2"));
}
