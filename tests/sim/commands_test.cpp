// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

TEST_CASE("simulate writes the features of each view and finds them equal to the golden model") {
  const Scratch scratch;
  const std::string rtl = (scratch / "rtl").string(), golden = (scratch / "golden").string();
  const Run run = run_program("simulate " + kStudioScene + " --check --out " + rtl);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());  // quiet: standard error is no terminal here
  CHECK_THAT(run.out, Contains("equal to the golden model: 3 frames, 405000 contour beats"));
  REQUIRE(
      run_program("simulate " + kStudioScene + " --frontend golden --out " + golden).exit_code ==
      0);
  for (const char* file : {"/000034/000000.png", "/000034/000001.csv", "/000034/000002.csv"}) {
    CHECK(read_whole(rtl + file, "features") == read_whole(golden + file, "features"));
  }
  CHECK_THAT(read_whole(rtl + "/000034/000000.csv", "vertices"), Contains("x,y,branches"));
}

TEST_CASE("simulate --json gives the figures for machines, and a trace can be had") {
  const Scratch scratch;
  const std::string image = (scratch / "dot.pgm").string(), trace = (scratch / "t.fst").string();
  scratch.write("dot.pgm",
                "P2 6 5 255\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 9 9 0 0 0 0 9 9 0 0 0 0 0 0 0 0\n");
  const Run run = run_program("simulate " + image + " --json --check --trace " + trace);
  CHECK(run.exit_code == 0);
  const auto figures = nlohmann::json::parse(run.out);
  CHECK(figures.at("frames") == 1);
  CHECK(figures.at("pixels") == 30);
  CHECK(figures.at("compared").at("beats") == 30);
  CHECK(std::filesystem::file_size(trace) > 0);
}

TEST_CASE("simulate names what is wrong on one line with exit code 2") {
  const Scratch scratch;
  scratch.write("photos/a.png", "no picture");
  const auto message = [&](const std::string& arguments) {
    const Run run = run_program("simulate " + arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    return run.err;
  };
  CHECK_THAT(message("/no/such/thing"), Contains("/no/such/thing: no such file or folder"));
  CHECK_THAT(message((scratch / "photos").string()), Contains("a.png"));
  std::filesystem::create_directory(scratch / "empty");
  CHECK_THAT(message((scratch / "empty").string()), Contains("no image in it"));
  scratch.write(
      "wide.pgm", "P2 1921 5 255\n" + [] {
        std::string zeros;
        for (int i = 0; i < 1921 * 5; ++i) zeros += "0 ";
        return zeros + "\n";
      }());
  CHECK_THAT(message((scratch / "wide.pgm").string()), Contains("1921 x 5 px; this build takes"));
  CHECK_THAT(message(kStudioScene + " --frontend golden --check"), Contains("--frontend rtl"));
}

TEST_CASE("simulate passes over unreadable frames only if asked to") {
  const Scratch scratch;
  scratch.write("mixed/a.png", "no picture");
  scratch.write("mixed/b.pgm", "P2 5 5 255\n0 0 0 0 0 0 0 0 0 0 0 0 9 0 0 0 0 0 0 0 0 0 0 0 0\n");
  const std::string mixed = "simulate " + (scratch / "mixed").string() + " --quiet";
  const Run refused = run_program(mixed);
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Contains("a.png") && Contains("--skip-unreadable passes over it"));
  const Run run = run_program(mixed + " --skip-unreadable");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains("a.png") && Contains("passed over"));
  CHECK_THAT(run.out, Contains("1 frames"));
}

TEST_CASE("simulate --check names the input in which it finds a difference") {
  const Scratch scratch;
  const std::string image = (scratch / "square.pgm").string();
  const auto pixel = [](int i) { return i / 12 % 8 > 2 && i % 12 > 4 ? "200 " : "20 "; };
  std::string pixels;
  for (int i = 0; i < 12 * 8; ++i) pixels += pixel(i);
  scratch.write("square.pgm", "P2 12 8 255\n" + pixels + "\n");
  const Run run = run_program("simulate " + image + " --check --spoil");
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.err, Contains("square/000000: first_contour differs: seed 1, view 0, frame 0"));
  CHECK(run_program("simulate " + image + " --spoil").exit_code == 2);
}

TEST_CASE("a file that cannot be written is named before the work, not behind it") {
  for (const char* option : {"--junit", "--coverage", "--trace"}) {
    // A day's frames: only a refusal at once ends in time.
    const Run run =
        run_program(std::string("verify --frames 100000000 ") + option + " /no/such/folder/file");
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains("/no/such/folder/file: cannot be written"));
  }
  const Run run = run_program("simulate " + kStudioScene + " --trace /no/such/folder/file");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Contains("/no/such/folder/file: cannot be written"));
}

TEST_CASE("seeds and counts that are none are refused on one line") {
  for (const char* arguments : {"verify --seed -1", "verify --frames 1e30", "verify --frames x",
                                "verify --trace-clocks -1", "simulate . --seed -1"}) {
    const Run run = run_program(arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK_THAT(run.err, Contains("expected"));
  }
}

TEST_CASE("verify counts what it compared, the same for any number of jobs") {
  const Scratch scratch;
  const std::string junit = (scratch / "report.xml").string();
  const std::string verify =
      "verify --frames 40 --seed 5 --pictures " TRIHEDRON_TESTVECTORS "/photographs";
  const Run one = run_program(verify);
  const Run two = run_program(verify + " --jobs 2 --junit " + junit);
  CHECK(one.exit_code == 0);
  CHECK(two.exit_code == 0);
  CHECK_THAT(one.out, Contains("equal to the golden model") && Contains("seeds 5 to"));
  CHECK(one.out.substr(0, one.out.rfind(',')) == two.out.substr(0, two.out.rfind(',')));
  const std::string report = read_whole(junit, "report");
  CHECK_THAT(report, Contains("failures=\"0\"") && Contains("name=\"seed 5\""));
  CHECK(run_program("verify --frames 0").exit_code == 2);
}

TEST_CASE(
    "a failing regression prints the one command that repeats it, with the waveform before it") {
  const Scratch scratch;
  const std::string junit = (scratch / "report.xml").string();
  const Run run = run_program("verify --frames 60 --seed 1 --jobs 2 --spoil --junit " + junit);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out, Contains("FAILED: first_contour differs: seed"));
  const std::size_t at =
      run.out.find("repeat: trihedron ") + std::string("repeat: trihedron ").size();
  std::string repeat = run.out.substr(at, run.out.find('\n', at) - at);
  CHECK_THAT(read_whole(junit, "report"), Contains(">repeat: trihedron " + repeat + "</failure>"));
  const std::size_t trace = repeat.find("difference.fst");
  REQUIRE(trace != std::string::npos);
  const std::string waveform = (scratch / "difference.fst").string();
  repeat.replace(trace, std::string("difference.fst").size(), waveform);
  const Run again = run_program(repeat + " --trace-clocks 100");
  CHECK(again.exit_code == 1);
  const auto failure = [](const std::string& out) { return out.substr(0, out.find('\n')); };
  CHECK(failure(again.out) == failure(run.out));
  const auto windowed = std::filesystem::file_size(waveform);
  run_program(repeat);
  CHECK(windowed < std::filesystem::file_size(waveform));
}

TEST_CASE(
    "verify that is interrupted says what it left out, whoever of its processes gets the signal") {
  const Scratch scratch;
  const std::string err = (scratch / "err").string();
  scratch.write("interrupt.sh",
                std::string(TRIHEDRON_BINARY) + " verify --frames 3000 --seed 3 --jobs 2 2>" + err +
                    " >/dev/null & program=$!\n"
                    "until [ -n \"$(cat /proc/$program/task/$program/children)\" ]; do\n"
                    "  kill -0 $program || exit 3\ndone\n"
                    "kill -TERM $program; wait $program\n");
  const int status = std::system(("bash " + (scratch / "interrupt.sh").string()).c_str());
  CHECK(WEXITSTATUS(status) == 128 + SIGTERM);
  CHECK_THAT(read_whole(err, "errors"),
             Contains("trihedron: interrupted;") && Contains("cases were left out"));
}

TEST_CASE("verify writes its functional coverage, hit bins and missed ones") {
  const Scratch scratch;
  const std::string file = (scratch / "coverage.json").string();
  REQUIRE(run_program("verify --frames 20 --jobs 2 --coverage " + file).exit_code == 0);
  const auto coverage = nlohmann::json::parse(read_whole(file, "coverage"));
  CHECK(coverage.at("frames") >= 15);
  CHECK(coverage.at("groups").at("contour flags").at("none") > 0);
  CHECK(coverage.at("groups").at("fault x contour stalls").size() == 50);
  CHECK(run_program("verify --frames 5 --code-coverage /tmp").exit_code == 2);
}

TEST_CASE("verify --json and --quiet say the same to machines and scripts") {
  const Run good = run_program("verify --frames 3 --json");
  CHECK(good.exit_code == 0);
  const auto verdict = nlohmann::json::parse(good.out);
  CHECK(verdict.at("passed") == true);
  CHECK(verdict.at("beats") > 0);
  const Run bad = run_program("verify --frames 3 --seed 2 --json --spoil");
  CHECK(bad.exit_code == 1);
  CHECK_THAT(nlohmann::json::parse(bad.out).at("failure").get<std::string>(), Contains("seed"));
  CHECK(run_program("verify --frames 3 --quiet").out.empty());
}
