// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const char* const kFile[] = {"/gray/000000.png", "/gray/000001.png", "/gray/000002.png"};

/// Three folders 0, 1, 2 that show the bundled scene `frames` times.
void make_streams(const Scratch& scratch, int frames) {
  for (int view = 0; view < 3; ++view) {
    const fs::path folder = scratch / std::to_string(view);
    fs::create_directories(folder);
    for (int frame = 0; frame < frames; ++frame)
      fs::copy(kStudioScene + kFile[view], folder / ("f" + std::to_string(frame) + ".png"));
  }
}

std::string stream_command(const Scratch& scratch, const std::string& more) {
  const auto at = [&](const char* name) { return (scratch / name).string(); };
  return "recognize --stream " + at("0") + " " + at("1") + " " + at("2") + " --cameras " +
         kStudioScene + "/scene_camera.json --models " + kModels + " --frontend golden --out " +
         at("out") + " " + more;
}

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
  return lines;
}

}  // namespace

TEST_CASE("a stream gives a line of JSON per frame, each as the scene alone gives it") {
  const Scratch scratch;
  make_streams(scratch, 2);
  const Run run = run_program(stream_command(scratch, ""));
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());  // standard error is no terminal: no progress
  const std::vector<json> lines = lines_of(run.out);
  REQUIRE(lines.size() == 2);
  const json alone = json::parse(run_program("recognize " + kStudioScene + " --models " + kModels +
                                             " --frontend golden --json")
                                     .out);
  REQUIRE(alone.at("objects").size() == 2);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CHECK(lines[i].at("frame") == i);
    CHECK(lines[i].at("objects") == alone.at("objects"));
  }
  CHECK(read_whole(scratch / "out/results.jsonl", "results") == run.out);
}

TEST_CASE("a stream of videos is read frame by frame") {
  const Scratch scratch;
  for (int view = 0; view < 3; ++view) {
    const cv::Mat image = cv::imread(kStudioScene + kFile[view]);
    const std::string file = (scratch / std::to_string(view)).string() + ".avi";
    cv::VideoWriter video(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, image.size());
    REQUIRE(video.isOpened());
    for (int frame = 0; frame < 3; ++frame) video.write(image);
    video.release();
    fs::rename(file, scratch / std::to_string(view));
  }
  const Run run = run_program(stream_command(scratch, "--limit 2"));
  CHECK(run.exit_code == 0);
  const std::vector<json> lines = lines_of(run.out);
  REQUIRE(lines.size() == 2);
  for (const json& line : lines) CHECK(line.at("objects").size() == 2);
}

TEST_CASE("a stream that goes wrong is named on one line, with the frames before it written") {
  const Scratch scratch;
  make_streams(scratch, 2);
  const fs::path second = scratch / "1/f1.png";
  const auto message = [&](const std::string& more, std::size_t lines) {
    const Run run = run_program(stream_command(scratch, "--quiet " + more));
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
    CHECK(lines_of(read_whole(scratch / "out/results.jsonl", "results")).size() == lines);
    return run.err;
  };
  SECTION("one ends early") {
    fs::remove(second);
    CHECK_THAT(message("", 1), Contains("ends after 1 frames") && Contains("equal length"));
  }
  SECTION("a frame of another size") {
    cv::imwrite(second.string(), cv::Mat(300, 400, CV_8U, 120.0));
    CHECK_THAT(message("", 1), Contains("f1.png: the image is 400 x 300 px; expected 450 x 300"));
  }
  SECTION("a frame that cannot be read") {
    scratch.write("1/f1.png", "no image, but long enough for one");
    CHECK_THAT(message("", 1), Contains("1/f1.png: not a readable image"));
    const Run run = run_program(stream_command(scratch, "--skip-unreadable"));
    CHECK(run.exit_code == 0);
    CHECK_THAT(lines_of(run.out).at(1).at("error").get<std::string>(), Contains("1/f1.png"));
  }
}

TEST_CASE("streams that cannot be opened are named on one line with exit code 2") {
  const Scratch scratch;
  make_streams(scratch, 1);
  const std::string two = (scratch / "0").string() + " " + (scratch / "1").string();
  const std::string cameras = " --cameras " + kStudioScene + "/scene_camera.json";
  const auto message = [&](const std::string& arguments) {
    const Run run = run_program("recognize --models " + kModels + " " + arguments);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
    CHECK(run.out.empty());
    return run.err;
  };
  CHECK_THAT(message("--stream " + two + cameras), Contains("3 views, but there are 2 streams"));
  CHECK_THAT(message("--stream " + two), Contains("needs --cameras"));
  CHECK_THAT(message("--stream " + two + " camera:93" + cameras), Contains("camera:93: cannot be"));
  CHECK_THAT(message("--stream " + two + " camera:x" + cameras), Contains("camera:0, camera:1"));
  CHECK_THAT(message("--stream " + two + " none.mp4" + cameras),
             Contains("none.mp4: no such file"));
  CHECK_THAT(message("--stream " + two + " " + kStudioScene + "/scene_gt.json" + cameras),
             Contains("neither an image nor a video"));
  CHECK_THAT(message(""), Contains("SCENE is required"));
}

TEST_CASE("an interrupted stream ends with what was done written") {
  const Scratch scratch;
  make_streams(scratch, 400);  // far more than are done before the signal
  const std::string result = (scratch / "out/results.jsonl").string();
  for (const char* signal : {"INT", "TERM"}) {
    // The reader takes one line and signals the program: no sleeps.
    const std::string script = "coproc " + std::string(TRIHEDRON_BINARY) + " " +
                               stream_command(scratch, "") +
                               "; program=$COPROC_PID; read -r line <&${COPROC[0]}; kill -" +
                               signal + " $program; cat <&${COPROC[0]} >/dev/null; wait $program";
    scratch.write("run.sh", script);
    const int status = std::system(("bash " + (scratch / "run.sh").string()).c_str());
    CHECK(WEXITSTATUS(status) == 128 + (std::string(signal) == "INT" ? SIGINT : SIGTERM));
    const std::vector<json> lines = lines_of(read_whole(result, "results"));
    CHECK(!lines.empty());
    CHECK(lines.size() < 400);
    CHECK(lines.back().at("objects").size() == 2);
    for (const auto& entry : fs::directory_iterator(scratch / "out"))
      CHECK(entry.path().filename() == "results.jsonl");  // nothing half written beside it
    fs::remove(result);
  }
}

TEST_CASE("memory does not grow with the length of a stream") {
  const Scratch scratch;
  make_streams(scratch, 12);
  const auto peak_kb = [&](int frames) {
    const std::string file = (scratch / "peak").string();
    const std::string command =
        "bash -c '" + std::string(TRIHEDRON_BINARY) + " " +
        stream_command(scratch, "--quiet --limit " + std::to_string(frames)) +
        " & wait $!; exit $?'";
    rusage before{}, after{};
    getrusage(RUSAGE_CHILDREN, &before);
    REQUIRE(std::system(command.c_str()) == 0);
    getrusage(RUSAGE_CHILDREN, &after);
    return after.ru_maxrss;  // of the largest child so far
  };
  const long few = peak_kb(2), many = peak_kb(12);
  constexpr double kSlack = 1.1;  // an image is 2 % of it: ten more frames kept would show
  CHECK(static_cast<double>(many) < kSlack * static_cast<double>(few));
}
