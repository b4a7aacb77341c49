// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/commands.hpp"
#include "cli/frame_inputs.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "golden/error.hpp"
#include "io/feature_files.hpp"
#include "io/views.hpp"
#include "sim/simulator.hpp"

namespace trihedron::cli {
namespace {

struct Arguments {
  std::vector<std::string> inputs;
  std::string out, trace, front_end = "rtl";
  std::uint64_t seed = 1;
  double idles = 0.0, stalls = 0.0;
  int limit = 0;
  bool check = false, keep_going = false, json = false, quiet = false;
};

/// Where a frame in the pipeline comes from, to name its results when they arrive.
struct Ticket {
  std::string sequence;
  int id = 0;
};

/// One simulation of many frames: deals them out to the views and takes the features in.
class Job {
 public:
  explicit Job(const Arguments& arguments)
      : arguments_(arguments),
        inputs_(arguments.inputs, arguments.keep_going),
        progress_(inputs_.count(), "frames", arguments.quiet) {}

  int run() {
    const Interruption interruption;
    const auto start = std::chrono::steady_clock::now();
    const sim::Report report = arguments_.front_end == "rtl" ? simulate() : compute();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    progress_.clear();
    if (arguments_.json)
      print_json(report, time.count());
    else
      print_summary(report, time.count());
    if (report.mismatch) fmt::print(stderr, "trihedron: {}\n", report.mismatch->text());
    if (report.mismatch || (arguments_.check && !report.passed())) return kNothingFound;
    if (Interruption::requested()) return Interruption::exit_code();
    return done_ > 0 ? kDone : kNothingFound;
  }

 private:
  sim::Report simulate() {
    sim::RunOptions options;
    options.seed = arguments_.seed;
    options.check = arguments_.check;
    options.trace_file = arguments_.trace;
    options.pixel_idles = {arguments_.idles, 8};
    options.contour_stalls = options.vertex_stalls = {arguments_.stalls, 8};
    return sim::Simulator::instance().run(
        options, [this](int view) { return next_for(view); },
        [this](sim::FrameResult&& frame) {
          const auto view = static_cast<std::size_t>(frame.view);
          const Ticket ticket = std::move(in_flight_[view].front());
          in_flight_[view].pop_front();
          finish(ticket, frame.features, frame.latency_clocks);
        });
  }

  sim::Report compute() {
    while (std::optional<InputFrame> frame = next()) {
      finish({frame->sequence, frame->id}, golden_front_end()({frame->grey}).front(), 0);
    }
    return {};
  }

  std::optional<InputFrame> next() {
    if (arguments_.limit > 0 && started_ == arguments_.limit) return std::nullopt;
    if (Interruption::requested()) return std::nullopt;  // what is in the pipeline still comes out
    std::optional<InputFrame> frame = inputs_.next();
    started_ += frame.has_value();
    return frame;
  }

  /// The images of a scene go to their own views, all others to whichever view is free.
  std::optional<sim::SourceFrame> next_for(int view) {
    auto& waiting = waiting_[static_cast<std::size_t>(view)];
    while (waiting.empty()) {
      std::optional<InputFrame> frame = next();
      if (!frame) return std::nullopt;
      const int home = frame->view < 0 ? view : frame->view;
      waiting_[static_cast<std::size_t>(home)].push_back(std::move(*frame));
    }
    const InputFrame frame = std::move(waiting.front());
    waiting.pop_front();
    in_flight_[static_cast<std::size_t>(view)].push_back({frame.sequence, frame.id});
    return sim::SourceFrame{to_grey_image(frame.grey)};
  }

  void finish(const Ticket& ticket, const ViewFeatures& features, std::uint64_t latency) {
    ++done_;
    if (!arguments_.out.empty()) {
      write_features(std::filesystem::path(arguments_.out) / ticket.sequence, ticket.id, features);
    }
    std::size_t contour = 0;
    for (const ContourBeat& beat : features.contour) contour += beat.contour();
    contour_pixels_ += contour;
    vertices_ += features.vertices.size();
    if (!arguments_.quiet && !arguments_.json) {
      progress_.clear();
      fmt::print("{}/{:06} {}x{} px: {} contour px, {} vertices, {} lost{}\n", ticket.sequence,
                 ticket.id, features.width, features.height, contour, features.vertices.size(),
                 features.vertices_lost,
                 latency > 0 ? fmt::format(", latency {} clocks", latency) : "");
    }
    progress_.step();
  }

  void print_summary(const sim::Report& report, double seconds) const {
    fmt::print("{} frames, {} contour px, {} vertices in {:.2f} s", done_, contour_pixels_,
               vertices_, seconds);
    if (report.clocks > 0) {
      const Totals total(report);
      fmt::print(
          "; {} clocks ({:.2f} Mclk/s), {} px in, {} input stalls, {} idle clocks, "
          "latency at most {} clocks",
          report.clocks, static_cast<double>(report.clocks) / seconds / 1e6, total.pixels,
          total.stalls, total.idles, total.latency);
    }
    fmt::print("\n");
    if (arguments_.check && report.passed()) {
      fmt::print(
          "equal to the golden model: {} frames, {} contour beats, {} records, {} registers\n",
          report.compared.frames, report.compared.beats, report.compared.records,
          report.compared.registers);
    }
  }

  void print_json(const sim::Report& report, double seconds) const {
    const Totals total(report);
    nlohmann::ordered_json out = {{"frames", done_},
                                  {"contour_px", contour_pixels_},
                                  {"vertices", vertices_},
                                  {"seconds", seconds},
                                  {"clocks", report.clocks},
                                  {"pixels", total.pixels},
                                  {"input_stalls", total.stalls},
                                  {"input_idles", total.idles},
                                  {"latency_clocks", total.latency}};
    out["compared"] = {{"frames", report.compared.frames},
                       {"beats", report.compared.beats},
                       {"records", report.compared.records},
                       {"registers", report.compared.registers}};
    if (report.mismatch) out["mismatch"] = report.mismatch->text();
    fmt::print("{}\n", out.dump(1));
  }

  struct Totals {
    explicit Totals(const sim::Report& report) {
      for (const sim::ViewStatistics& view : report.views) {
        pixels += view.pixels;
        stalls += view.input_stalls;
        idles += view.input_idles;
        latency = std::max(latency, view.latency_clocks);
      }
    }
    std::uint64_t pixels = 0, stalls = 0, idles = 0, latency = 0;
  };

  const Arguments& arguments_;
  FrameInputs inputs_;
  Progress progress_;
  std::array<std::deque<InputFrame>, sim::kViews> waiting_;
  std::array<std::deque<Ticket>, sim::kViews> in_flight_;
  int started_ = 0, done_ = 0;
  std::uint64_t contour_pixels_ = 0, vertices_ = 0;
};

void add_options(CLI::App& command, Arguments& arguments) {
  command
      .add_option("INPUT", arguments.inputs, "Images, folders of images, scenes, videos, camera:0")
      ->required();
  command
      .add_option("--out", arguments.out, "Write SCENE/000000.png (contour) and .csv (vertices)")
      ->type_name("DIR");
  command.add_flag("--check", arguments.check, "Hold every beat against the golden model");
  command.add_option("--trace", arguments.trace, "Write the waveform")->type_name("FILE.fst");
  command.add_option("--frontend", arguments.front_end, "Simulated RTL, or the golden model alone")
      ->check(CLI::IsMember({"rtl", "golden"}))
      ->capture_default_str();
  command.add_option("--seed", arguments.seed, "Of the random stalls")->capture_default_str();
  command.add_option("--idle", arguments.idles, "Chance of an idle at each pixel")
      ->check(CLI::Range(0.0, 0.95))
      ->capture_default_str();
  command.add_option("--stall", arguments.stalls, "Chance of back-pressure at each clock")
      ->check(CLI::Range(0.0, 0.95))
      ->capture_default_str();
  command.add_option("--limit", arguments.limit, "Stop after so many frames; 0: all")
      ->check(kNotNegative);
  command.add_flag("--keep-going", arguments.keep_going, "Pass over unreadable frames");
  command.add_flag("--quiet", arguments.quiet, "Only the closing lines");
  command.add_flag("--json", arguments.json, "Print the result as JSON");
  command.footer(
      "Example:\n  trihedron simulate testvectors/scenes/studio-two/000034 --out features --check");
}

}  // namespace

void add_simulate(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "simulate", "Send images, folders, scenes or videos through the simulated hardware");
  add_options(*command, *arguments);
  command->callback([arguments, &exit_code] {
    if (arguments->front_end != "rtl" && (arguments->check || !arguments->trace.empty())) {
      throw Error("--check and --trace need --frontend rtl");
    }
    exit_code = Job(*arguments).run();
  });
}

}  // namespace trihedron::cli
