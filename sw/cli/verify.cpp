// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/commands.hpp"
#include "cli/first_failure.hpp"
#include "cli/frame_inputs.hpp"
#include "cli/interrupt.hpp"
#include "cli/shards.hpp"
#include "cli/terminal.hpp"
#include "cli/verify_report.hpp"
#include "golden/error.hpp"
#include "io/file.hpp"
#include "sim/functional_coverage.hpp"
#include "sim/regression.hpp"

namespace trihedron::cli {
namespace {

/// Clocks of waveform before a difference: the ten lines of latency at full width.
constexpr std::uint64_t kTraceClocks = 20000;

struct Arguments {
  int frames = 300;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::string junit, trace, coverage, code_coverage;
  std::uint64_t trace_clocks = kTraceClocks;
  std::vector<std::string> pictures;
  ShardArguments shard;
  bool spoil = false, json = false, quiet = false;
};

std::string verdict(const sim::Report& report) {
  if (report.mismatch) return report.mismatch->text();
  return report.passed() ? "" : fmt::format("seed {}: nothing was compared", report.seed);
}

sim::RegressionCase case_of(std::uint64_t seed, const Arguments& arguments,
                            const std::vector<sim::GreyImage>& pictures) {
  sim::RegressionCase regression_case = sim::make_case(seed, pictures);
  if (arguments.spoil) {
    regression_case.options.expected_thresholds = golden::FrontEndConfig{};
    regression_case.options.expected_thresholds->first_contour.noise_floor = 511;
  }
  return regression_case;
}

/// A failed case twice more: where it differs, then the clocks before that in a waveform.
void trace_difference(sim::RegressionCase regression_case, const Arguments& arguments) {
  const sim::Report report = sim::run_case(regression_case);
  const std::uint64_t clock = report.mismatch ? report.mismatch->clock : 0;
  sim::RunOptions& options = regression_case.options;
  options.trace_file = arguments.trace;
  options.trace_from_clock = clock > arguments.trace_clocks ? clock - arguments.trace_clocks : 0;
  sim::run_case(regression_case);
}

CaseOutcome run_one(std::uint64_t seed, const Arguments& arguments,
                    const std::vector<sim::GreyImage>& pictures) {
  CaseOutcome outcome;
  outcome.seed = seed;
  const auto start = std::chrono::steady_clock::now();
  sim::RegressionCase regression_case = case_of(seed, arguments, pictures);
  if (!arguments.code_coverage.empty()) {
    regression_case.options.code_coverage_file =
        fmt::format("{}/{}.dat", arguments.code_coverage, getpid());
  }
  const bool wanted = !arguments.coverage.empty();
  const sim::Report report = sim::run_case(regression_case, wanted ? &outcome.covered : nullptr);
  outcome.clocks = report.clocks;
  outcome.compared = report.compared;
  outcome.failure = verdict(report);
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

/// As a shell takes it for one word.
std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789_-+./:=@%,") == word.npos;
  return plain ? word : out + "'";
}

/// The command that repeats one case.
std::string repeat_command(const CaseOutcome& outcome, const Arguments& arguments) {
  std::string command = fmt::format("trihedron verify --seed {} --frames 1", outcome.seed);
  for (const std::string& picture : arguments.pictures) command += " --pictures " + quoted(picture);
  return command + (arguments.spoil ? " --spoil" : "") + " --trace difference.fst";
}

/// Everything that was compared, and the clocks it took.
struct Sum {
  sim::Compared compared;
  std::uint64_t clocks = 0;
  const CaseOutcome* failed = nullptr;  ///< the first
  std::uint64_t last_seed = 0;          ///< of those that ran
};

Sum sum_of(const std::vector<CaseOutcome>& outcomes) {
  Sum sum;
  for (const CaseOutcome& outcome : outcomes) {
    if (!sum.failed && !outcome.failure.empty()) sum.failed = &outcome;
    sum.compared.frames += outcome.compared.frames;
    sum.compared.beats += outcome.compared.beats;
    sum.compared.records += outcome.compared.records;
    sum.compared.registers += outcome.compared.registers;
    sum.clocks += outcome.clocks;
    if (!outcome.skipped) sum.last_seed = outcome.seed;
  }
  return sum;
}

void print_json(const Sum& sum, const std::vector<CaseOutcome>& outcomes,
                const Arguments& arguments, double seconds) {
  nlohmann::ordered_json out = {{"passed", sum.failed == nullptr},
                                {"frames", sum.compared.frames},
                                {"beats", sum.compared.beats},
                                {"records", sum.compared.records},
                                {"registers", sum.compared.registers},
                                {"first_seed", outcomes.front().seed},
                                {"last_seed", sum.last_seed},
                                {"clocks", sum.clocks},
                                {"seconds", seconds}};
  if (sum.failed) {
    out["failure"] = sum.failed->failure;
    out["repeat"] = repeat_command(*sum.failed, arguments);
    if (!arguments.trace.empty()) out["waveform"] = arguments.trace;
  }
  fmt::print("{}\n", out.dump(1));
}

int report(const std::vector<CaseOutcome>& outcomes, const Arguments& arguments, double seconds) {
  const Sum sum = sum_of(outcomes);
  if (arguments.json) {
    print_json(sum, outcomes, arguments, seconds);
  } else if (sum.failed) {
    fmt::print("{} {}\nrepeat: {}\n", toned(stdout, Tone::kBad, "FAILED:"), sum.failed->failure,
               repeat_command(*sum.failed, arguments));
    if (!arguments.trace.empty()) fmt::print("waveform: {}\n", arguments.trace);
  } else if (sum.compared.beats == 0) {
    fmt::print("nothing was compared\n");
  } else if (!arguments.quiet) {
    fmt::print(
        "equal to the golden model: {} frames, {} contour beats, {} vertex-stream records, "
        "{} register values; seeds {} to {}, {} clocks, {:.1f} s\n",
        sum.compared.frames, sum.compared.beats, sum.compared.records, sum.compared.registers,
        outcomes.front().seed, sum.last_seed, sum.clocks, seconds);
  }
  if (!sum.failed && Interruption::requested()) {
    const auto left_out = std::count_if(outcomes.begin(), outcomes.end(),
                                        [](const CaseOutcome& outcome) { return outcome.skipped; });
    fmt::print(stderr, "trihedron: interrupted; {} of {} cases were left out\n", left_out,
               outcomes.size());
    return Interruption::exit_code();
  }
  return sum.failed ? kNothingFound : kDone;
}

/// Runs the cases; nothing where a shard keeps its part for `merge`. Ctrl-C leaves out what has not
/// begun, but in a shard, which is whole or nothing.
std::optional<std::vector<std::string>> run_cases(const Arguments& arguments,
                                                  const std::vector<std::uint64_t>& seeds) {
  const std::vector<sim::GreyImage> pictures = read_pictures(arguments.pictures);
  std::optional<Interruption> interruption;
  if (arguments.shard.shard.empty()) interruption.emplace();
  FirstFailure failure;
  const auto texts =
      run_sharded(seeds.size(), arguments.jobs, "cases", arguments.shard, [&](std::size_t item) {
        CaseOutcome outcome;
        outcome.seed = seeds[item];
        outcome.skipped = failure.is_before(item) || Interruption::requested();
        if (!outcome.skipped) outcome = run_one(seeds[item], arguments, pictures);
        if (!outcome.failure.empty()) failure.note(item);
        return outcome.to_text();
      });
  if (!texts && failure.any()) fmt::print(stderr, "trihedron: a case failed; merge says which\n");
  return texts;
}

int run(const Arguments& arguments) {
  // Before hours of work, not behind them.
  for (const std::string& file : {arguments.junit, arguments.coverage, arguments.trace})
    if (!file.empty()) require_writable(file);
  const std::vector<std::uint64_t> seeds = plan(arguments);
  const auto start = std::chrono::steady_clock::now();
  const std::optional<std::vector<std::string>> texts = run_cases(arguments, seeds);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (!texts) return kDone;
  std::vector<CaseOutcome> outcomes;
  for (const std::string& text : *texts) outcomes.push_back(CaseOutcome::from_text(text));
  const auto repeat = [&](const CaseOutcome& outcome) {
    return repeat_command(outcome, arguments);
  };
  if (!arguments.junit.empty()) write_junit(arguments.junit, outcomes, repeat);
  if (!arguments.coverage.empty()) write_coverage(arguments.coverage, outcomes);
  const CaseOutcome* const failed = sum_of(outcomes).failed;
  if (failed && !arguments.trace.empty())
    trace_difference(case_of(failed->seed, arguments, read_pictures(arguments.pictures)),
                     arguments);
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
  command->add_option("--seed", arguments->seed, "Seed of the first case")
      ->check(kNotNegative)
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "Processes")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--pictures", arguments->pictures, "Real images or videos to crop from")
      ->type_name("INPUT");
  command->add_option("--junit", arguments->junit, "Write a JUnit report")->type_name("FILE");
  command->add_option("--trace", arguments->trace, "Write the waveform before the first difference")
      ->type_name("FILE.fst");
  command->add_option("--trace-clocks", arguments->trace_clocks, "Clocks of that waveform")
      ->check(kNotNegative)
      ->capture_default_str();
  command->add_option("--coverage", arguments->coverage, "Write the functional coverage as JSON")
      ->type_name("FILE");
  command
      ->add_option("--code-coverage", arguments->code_coverage,
                   "Write Verilator's coverage data; needs the preset rtl-coverage")
      ->type_name("DIR");
  command->add_flag("--json", arguments->json, "Print the verdict as JSON");
  command->add_flag("--quiet", arguments->quiet, "Print differences only");
  arguments->shard.add_to(*command);
  command->add_flag("--spoil", arguments->spoil,
                    "Expect contours of NOISE_FLOOR 511 only: shows what a failure looks like");
  command->footer("Example:\n  trihedron verify --frames 1000 --seed 7 --jobs 2");
  command->callback([arguments, &exit_code] {
    if (!arguments->code_coverage.empty() && !sim::kCountsCodeCoverage) {
      throw Error("--code-coverage: this build does not count it; right is preset rtl-coverage");
    }
    exit_code = run(*arguments);
  });
}

}  // namespace trihedron::cli
