// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/shards.hpp"
#include "cli/simulate_job.hpp"
#include "golden/error.hpp"
#include "io/file.hpp"

namespace trihedron::cli {
namespace {

struct Arguments {
  SimulateArguments job;
  ShardArguments shard;
  bool json = false, quiet = false;
};

bool prints_frames(const Arguments& arguments) { return !arguments.quiet && !arguments.json; }

void print_summary(const SimulationOutcome& outcome, bool checked, double seconds) {
  fmt::print("{} frames, {} contour px, {} vertices in {:.2f} s", outcome.frames,
             outcome.contour_px, outcome.vertices, seconds);
  if (outcome.clocks > 0)
    fmt::print(
        "; {} clocks ({:.2f} Mclk/s), {} px in, {} input stalls, {} idle clocks, "
        "latency at most {} clocks",
        outcome.clocks, static_cast<double>(outcome.clocks) / seconds / 1e6, outcome.pixels,
        outcome.input_stalls, outcome.input_idles, outcome.latency_clocks);
  fmt::print("\n");
  if (checked && outcome.passed)
    fmt::print("equal to the golden model: {} frames, {} contour beats, {} records, {} registers\n",
               outcome.compared.frames, outcome.compared.beats, outcome.compared.records,
               outcome.compared.registers);
}

void print_json(const SimulationOutcome& outcome, double seconds) {
  nlohmann::ordered_json out = {{"frames", outcome.frames},
                                {"contour_px", outcome.contour_px},
                                {"vertices", outcome.vertices},
                                {"seconds", seconds},
                                {"clocks", outcome.clocks},
                                {"pixels", outcome.pixels},
                                {"input_stalls", outcome.input_stalls},
                                {"input_idles", outcome.input_idles},
                                {"latency_clocks", outcome.latency_clocks}};
  out["compared"] = {{"frames", outcome.compared.frames},
                     {"beats", outcome.compared.beats},
                     {"records", outcome.compared.records},
                     {"registers", outcome.compared.registers}};
  if (!outcome.mismatch.empty()) out["mismatch"] = outcome.mismatch;
  fmt::print("{}\n", out.dump(1));
}

int report(const Arguments& arguments, const SimulationOutcome& outcome, double seconds) {
  if (arguments.json)
    print_json(outcome, seconds);
  else
    print_summary(outcome, arguments.job.check, seconds);
  if (!outcome.mismatch.empty()) fmt::print(stderr, "trihedron: {}\n", outcome.mismatch);
  if (!outcome.mismatch.empty() || (arguments.job.check && !outcome.passed)) return kNothingFound;
  if (Interruption::requested()) return Interruption::exit_code();
  return outcome.frames > 0 ? kDone : kNothingFound;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int run_whole(const Arguments& arguments) {
  const Interruption interruption;
  const auto start = std::chrono::steady_clock::now();
  FrameInputs inputs(arguments.job.inputs, arguments.job.skip_unreadable);
  SimulationOutcome outcome;
  {
    std::optional<std::size_t> count = inputs.count();
    const auto limit = static_cast<std::size_t>(arguments.job.limit);
    if (limit > 0) count = std::min(count.value_or(limit), limit);
    Progress progress(count, "frames", arguments.quiet);
    outcome = simulate_frames(arguments.job, inputs, [&](const std::string& line) {
      progress.clear();
      if (prints_frames(arguments)) fmt::print("{}\n", line);
      progress.step();
    });
  }
  return report(arguments, outcome, seconds_since(start));
}

/// A batch as text: the sums in the first line, then the frames' lines.
std::string run_batch(const Arguments& arguments, std::size_t first, std::size_t last) {
  FrameInputs inputs(arguments.job.inputs, arguments.job.skip_unreadable);
  inputs.take(first, last);
  std::string lines;
  const SimulationOutcome outcome = simulate_frames(
      arguments.job, inputs, [&](const std::string& line) { lines += line + "\n"; });
  return outcome.to_text() + "\n" + lines;
}

/// In batches: a shard's frames fill the three views' pipelines, and a video is wound on seldom.
int run_in_batches(const Arguments& arguments) {
  constexpr std::size_t kFrames = 30;
  const std::optional<std::size_t> frames =
      FrameInputs(arguments.job.inputs, arguments.job.skip_unreadable).count();
  if (!frames) throw Error("--shard: a live camera has no parts; expected images or videos");
  if (arguments.job.limit > 0 || !arguments.job.trace.empty() || !arguments.job.stats.empty())
    throw Error("--shard: not with --limit, --trace or --stats; expected the whole input");
  const auto start = std::chrono::steady_clock::now();
  const auto texts = run_sharded(
      (*frames + kFrames - 1) / kFrames, 1, "batches of 30 frames", arguments.shard,
      [&](std::size_t i) { return run_batch(arguments, i * kFrames, (i + 1) * kFrames); });
  if (!texts) return kDone;
  SimulationOutcome sum;
  for (const std::string& text : *texts) {
    const std::size_t end = text.find('\n');
    sum.add(SimulationOutcome::from_text(text.substr(0, end)));
    if (prints_frames(arguments)) fmt::print("{}", text.substr(end + 1));
  }
  return report(arguments, sum, seconds_since(start));
}

void add_options(CLI::App& command, Arguments& arguments) {
  SimulateArguments& job = arguments.job;
  command.add_option("INPUT", job.inputs, "Images, folders of images, scenes, videos, camera:0")
      ->required();
  command.add_option("--out", job.out, "Write SCENE/000000.png (contour) and .csv (vertices)")
      ->type_name("DIR");
  command.add_flag("--check", job.check, "Hold every beat against the golden model");
  command.add_option("--trace", job.trace, "Write the waveform")->type_name("FILE.fst");
  command.add_option("--frontend", job.front_end, "Simulated RTL, or the golden model alone")
      ->check(CLI::IsMember({"rtl", "golden"}))
      ->capture_default_str();
  command.add_option("--seed", job.seed, "Of the random stalls")
      ->check(kNotNegative)
      ->capture_default_str();
  command.add_option("--idle", job.idles, "Chance of an idle at each pixel")
      ->check(CLI::Range(0.0, 0.95))
      ->capture_default_str();
  command.add_option("--stall", job.stalls, "Chance of back-pressure at each clock")
      ->check(CLI::Range(0.0, 0.95))
      ->capture_default_str();
  command.add_option("--limit", job.limit, "Stop after so many frames; 0: all")
      ->check(kNotNegative);
  command.add_option("--stats", job.stats, "Write clocks, stalls and vertices of each frame")
      ->type_name("FILE.csv|.json");
  command.add_flag("--skip-unreadable", job.skip_unreadable, "Pass over unreadable frames");
  command.add_flag("--spoil", job.spoil,
                   "Check against contours of NOISE_FLOOR 511: shows what a difference looks like");
  command.add_flag("--quiet", arguments.quiet, "Only the closing lines");
  command.add_flag("--json", arguments.json, "Print the result as JSON");
  arguments.shard.add_to(command);
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
    const SimulateArguments& job = arguments->job;
    if (job.spoil && !job.check) throw Error("--spoil: needs --check");
    if (!job.trace.empty()) require_writable(job.trace);
    if (job.front_end != "rtl" && (job.check || !job.trace.empty()))
      throw Error("--check and --trace need --frontend rtl");
    const bool parts = arguments->shard.merge || !arguments->shard.shard.empty();
    exit_code = parts ? run_in_batches(*arguments) : run_whole(*arguments);
  });
}

}  // namespace trihedron::cli
