// SPDX-License-Identifier: Apache-2.0
// Long sequences and videos through `simulate`.
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

/// A video of a square that moves over noise-free ground.
std::string make_video(const Scratch& scratch, int frames, cv::Size size) {
  const std::string file = (scratch / "square.avi").string();
  cv::VideoWriter video(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, size);
  REQUIRE(video.isOpened());
  for (int i = 0; i < frames; ++i) {
    cv::Mat image(size, CV_8UC3, cv::Scalar::all(40));
    cv::rectangle(image, {10 + i % 20, 12, 30, 25}, cv::Scalar::all(200), cv::FILLED);
    video.write(image);
  }
  return file;
}

/// Largest resident set of any child so far, KiB.
long largest_child() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("a video is checked frame by frame, with a line of statistics for each") {
  const Scratch scratch;
  const std::string video = make_video(scratch, 7, {80, 60});
  const std::string stats = (scratch / "frames.csv").string();
  const Run run = run_program("simulate " + video + " --check --quiet --stats " + stats);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("equal to the golden model: 7 frames, 33600 contour beats"));
  const std::vector<std::string> lines = lines_of(read_whole(stats, "statistics"));
  REQUIRE(lines.size() == 8);
  CHECK_THAT(lines[0], Contains("clocks") && Contains("input_stalls") && Contains("vertices"));
  CHECK_THAT(lines[1], Contains("square,") && Contains(",80,60,"));
}

TEST_CASE("statistics of a frame add up: clocks, latency and stalls, as JSON too") {
  const Scratch scratch;
  const std::string video = make_video(scratch, 6, {80, 60});
  const std::string stats = (scratch / "frames.json").string();
  REQUIRE(run_program("simulate " + video + " --stall 0.3 --quiet --stats " + stats).exit_code ==
          0);
  std::vector<bool> seen(6);
  for (const std::string& line : lines_of(read_whole(stats, "statistics"))) {
    const auto frame = nlohmann::json::parse(line);
    seen.at(frame.at("frame")) = true;
    CHECK(frame.at("status") == 0);
    CHECK(frame.at("contour_stalls") > 0);
    // Every pixel takes a clock, and the last comes out a latency after it went in.
    CHECK(frame.at("clocks") >= 80 * 60 + frame.at("latency_clocks").get<int>());
  }
  CHECK(std::count(seen.begin(), seen.end(), true) == 6);
}

TEST_CASE("a sequence ten times as long takes no more memory") {
  const Scratch scratch;
  const std::string video = make_video(scratch, 24, {160, 100});
  // A frame and its features are 0.4 MB, so that a tenth of what is kept by mistake would show.
  constexpr long kSlackKib = 4096;
  const auto simulate = [&](int times) {
    std::string inputs;
    for (int i = 0; i < times; ++i) inputs += video + " ";
    REQUIRE(run_program("simulate " + inputs + "--quiet").exit_code == 0);
    return largest_child();
  };
  const long few = simulate(1);
  CHECK(simulate(10) <= few + kSlackKib);
}

TEST_CASE("a video that ends early is named; what came before counts only if asked to go on") {
  const Scratch scratch;
  const std::string video = make_video(scratch, 12, {80, 60});
  const std::string whole = read_whole(video, "video");
  const std::string cut = (scratch / "cut.avi").string();
  write_whole(cut, whole.substr(0, whole.size() * 2 / 3));
  const Run stops = run_program("simulate " + cut + " --quiet");
  CHECK(stops.exit_code == 2);
  CHECK(is_one_line(stops.err));
  CHECK_THAT(stops.err, Contains("cut.avi"));
  const Run goes_on = run_program("simulate " + cut + " " + video + " --quiet --skip-unreadable");
  CHECK_THAT(goes_on.err, Contains("cut.avi") && Contains("passed over"));
  CHECK(goes_on.exit_code == 0);
}

TEST_CASE("a frame too wide for the build is named with the sizes that fit") {
  const Scratch scratch;
  const std::string image = (scratch / "wide.png").string();
  cv::imwrite(image, cv::Mat(10, 2000, CV_8UC1, cv::Scalar(9)));
  const Run run = run_program("simulate " + image);
  CHECK(run.exit_code == 2);
  CHECK(is_one_line(run.err));
  CHECK_THAT(run.err, Contains("wide.png: 2000 x 10 px; this build takes 5 to 1920"));
}
