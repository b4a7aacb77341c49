// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/commands.hpp"
#include "cli/frame_inputs.hpp"
#include "cli/workers.hpp"
#include "golden/error.hpp"
#include "sim/regression.hpp"

namespace trihedron::cli {
namespace {

struct Arguments {
  int frames = 300;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::string junit, trace;
  std::vector<std::string> pictures;
};

/// What one case came to; travels between processes as JSON.
struct Outcome {
  std::uint64_t seed = 0;
  double seconds = 0.0;
  std::uint64_t clocks = 0;
  sim::Compared compared;
  std::string failure;   ///< empty: all equal
  bool skipped = false;  ///< an earlier case of the same process failed
};

std::string to_text(const Outcome& o) {
  return nlohmann::json{o.seed,
                        o.seconds,
                        o.clocks,
                        o.compared.frames,
                        o.compared.beats,
                        o.compared.records,
                        o.compared.registers,
                        o.failure,
                        o.skipped}
      .dump();
}

Outcome from_text(const std::string& text) {
  const nlohmann::json o = nlohmann::json::parse(text);
  return {o[0], o[1], o[2], {o[3], o[4], o[5], o[6]}, o[7], o[8]};
}

Outcome run_one(std::uint64_t seed, const std::string& trace,
                const std::vector<sim::GreyImage>& pictures) {
  Outcome outcome;
  outcome.seed = seed;
  const auto start = std::chrono::steady_clock::now();
  sim::RegressionCase regression_case = sim::make_case(seed, pictures);
  regression_case.options.trace_file = trace;
  const sim::Report report = sim::run_case(regression_case);
  outcome.clocks = report.clocks;
  outcome.compared = report.compared;
  if (report.mismatch)
    outcome.failure = report.mismatch->text();
  else if (!report.passed())
    outcome.failure = fmt::format("seed {}: nothing was compared", seed);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

std::vector<std::uint64_t> plan(const Arguments& arguments) {
  std::vector<std::uint64_t> seeds;
  for (int frames = 0; frames < arguments.frames; frames += sim::frames_in_case(seeds.back())) {
    seeds.push_back(arguments.seed + seeds.size());
  }
  return seeds;
}

std::vector<sim::GreyImage> read_pictures(const std::vector<std::string>& inputs) {
  std::vector<sim::GreyImage> pictures;
  if (inputs.empty()) return pictures;
  FrameInputs frames(inputs, false);
  while (const std::optional<InputFrame> frame = frames.next()) {
    pictures.push_back(to_grey_image(frame->grey));
  }
  return pictures;
}

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

void write_junit(const std::string& file, const std::vector<Outcome>& outcomes) {
  std::ofstream out(file);
  std::size_t failures = 0, skipped = 0;
  double seconds = 0.0;
  for (const Outcome& outcome : outcomes) {
    failures += !outcome.failure.empty();
    skipped += outcome.skipped;
    seconds += outcome.seconds;
  }
  out << fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"trihedron verify\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" "
      "time=\"{:.3f}\">\n",
      outcomes.size(), failures, skipped, seconds);
  for (const Outcome& outcome : outcomes) {
    out << fmt::format("  <testcase classname=\"verify\" name=\"seed {}\" time=\"{:.3f}\">",
                       outcome.seed, outcome.seconds);
    if (outcome.skipped) out << "<skipped/>";
    if (!outcome.failure.empty()) {
      out << "<failure message=\"" << xml_escaped(outcome.failure) << "\"/>";
    }
    out << "</testcase>\n";
  }
  out << "</testsuite>\n";
  if (!out) throw Error("--junit " + file + ": cannot be written; expected a writable path");
}

/// The command that repeats one case.
std::string repeat_command(const Outcome& outcome, const Arguments& arguments) {
  std::string command = fmt::format("trihedron verify --seed {} --frames 1", outcome.seed);
  for (const std::string& picture : arguments.pictures) command += " --pictures " + picture;
  return command + " --trace difference.fst";
}

int report(const std::vector<Outcome>& outcomes, const Arguments& arguments, double seconds) {
  sim::Compared total;
  std::uint64_t clocks = 0;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.failure.empty()) {
      fmt::print("FAILED: {}\nrepeat: {}\n", outcome.failure, repeat_command(outcome, arguments));
      return kNothingFound;
    }
    total.frames += outcome.compared.frames;
    total.beats += outcome.compared.beats;
    total.records += outcome.compared.records;
    total.registers += outcome.compared.registers;
    clocks += outcome.clocks;
  }
  fmt::print(
      "equal to the golden model: {} frames, {} contour beats, {} vertex-stream records, "
      "{} register values; seeds {} to {}, {} clocks, {:.1f} s\n",
      total.frames, total.beats, total.records, total.registers, outcomes.front().seed,
      outcomes.back().seed, clocks, seconds);
  return kDone;
}

int run(const Arguments& arguments) {
  const std::vector<std::uint64_t> seeds = plan(arguments);
  const std::vector<sim::GreyImage> pictures = read_pictures(arguments.pictures);
  const auto start = std::chrono::steady_clock::now();
  bool failed = false;
  const std::vector<std::string> texts =
      run_workers(seeds.size(), arguments.jobs, "cases", [&](std::size_t item) {
        Outcome outcome;
        outcome.seed = seeds[item];
        outcome.skipped = failed;
        if (!failed) outcome = run_one(seeds[item], arguments.trace, pictures);
        failed = failed || !outcome.failure.empty();
        return to_text(outcome);
      });
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::vector<Outcome> outcomes;
  for (const std::string& text : texts) outcomes.push_back(from_text(text));
  if (!arguments.junit.empty()) write_junit(arguments.junit, outcomes);
  return report(outcomes, arguments, time.count());
}

}  // namespace

void add_verify(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("verify", "Random regression of the RTL against the golden model");
  command->add_option("--frames", arguments->frames, "Send at least so many frames")
      ->check(kPositive)
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Seed of the first case")->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "Processes")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--pictures", arguments->pictures, "Real images or videos to crop from")
      ->type_name("INPUT");
  command->add_option("--junit", arguments->junit, "Write a JUnit report")->type_name("FILE");
  command->add_option("--trace", arguments->trace, "Write the waveform of the last case")
      ->type_name("FILE.fst");
  command->footer("Example:\n  trihedron verify --frames 1000 --seed 7 --jobs 2");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace trihedron::cli
