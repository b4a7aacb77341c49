// SPDX-License-Identifier: Apache-2.0
#include "cli/recognize_stream.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/line_file.hpp"
#include "io/report_json.hpp"
#include "io/view_streams.hpp"
#include "recognition/recognizer.hpp"

namespace trihedron::cli {
namespace {

using Json = nlohmann::ordered_json;

class StreamJob {
 public:
  StreamJob(const StreamArguments& arguments, const RecognitionArguments& recognition,
            const std::string& out, bool quiet)
      : streams_(arguments.cameras, arguments.sources),
        library_(recognition.library(arguments.cameras)),
        recognizer_(library_),
        front_end_(recognition.make_front_end()),
        options_(recognition.options()),
        limit_(arguments.limit),
        skip_unreadable_(arguments.skip_unreadable),
        quiet_(quiet),
        progress_(frames_to_do(), "frames", quiet) {
    if (out.empty()) return;
    make_folder(out);
    file_ = std::make_unique<LineFile>(std::filesystem::path(out) / "results.jsonl");
  }

  int run() {
    const Interruption interruption;
    for (int frame = 0; limit_ == 0 || frame < limit_; ++frame) {
      if (Interruption::requested() || !streams_.advance()) break;
      put(line_of(frame).dump());
      progress_.step();
    }
    progress_.clear();
    if (file_) file_->close();
    if (Interruption::requested()) return Interruption::exit_code();
    return any_found_ ? kDone : kNothingFound;
  }

 private:
  std::optional<std::size_t> frames_to_do() const {
    const std::optional<int> there = streams_.count();
    if (limit_ > 0) return std::min(limit_, there.value_or(limit_));
    return there;
  }

  /// The frame's objects; with skip_unreadable a bad frame becomes a line that says what is wrong.
  Json line_of(int frame) {
    try {
      const Scene scene = streams_.frame();
      const RecognitionResult result =
          recognizer_.recognize(make_views(scene, front_end_), options_);
      const Json report = report_json(scene, result, library_);
      any_found_ = any_found_ || !result.objects.empty();
      return {{"frame", frame},
              {"objects", report["objects"]},
              {"rejections", result.rejections.size()},
              {"stages", report["stages"]}};
    } catch (const Error& error) {
      if (!skip_unreadable_) throw;
      return {{"frame", frame}, {"error", error.what()}};
    }
  }

  void put(const std::string& line) {
    if (file_) file_->write(line);
    if (quiet_) return;
    progress_.clear();
    fmt::print("{}\n", line);
    std::fflush(stdout);  // whoever reads the pipe gets each frame when it is done
  }

  ViewStreams streams_;
  std::vector<Model> library_;
  Recognizer recognizer_;
  FrontEnd front_end_;
  RecognitionOptions options_;
  int limit_;
  bool skip_unreadable_, quiet_, any_found_ = false;
  Progress progress_;
  std::unique_ptr<LineFile> file_;
};

}  // namespace

void StreamArguments::add_to(CLI::App& command) {
  command
      .add_option("--stream", sources,
                  "One video, folder of images, address or camera (camera:0) per view, frame by "
                  "frame; a line of JSON per frame")
      ->type_name("INPUT")
      ->expected(2, 64);
  command.add_option("--cameras", cameras, "With --stream: the calibration of the views, in order")
      ->type_name("scene_camera.json");
  command.add_option("--limit", limit, "With --stream: stop after so many frames; 0: all")
      ->check(kNotNegative);
  command.add_flag("--skip-unreadable", skip_unreadable,
                   "With --stream: pass over frames that cannot be read");
}

int recognize_stream(const StreamArguments& arguments, const RecognitionArguments& recognition,
                     const std::string& out, bool quiet) {
  if (arguments.cameras.empty())
    throw Error("--stream: needs --cameras; expected the scene_camera.json of the views");
  return StreamJob(arguments, recognition, out, quiet).run();
}

}  // namespace trihedron::cli
