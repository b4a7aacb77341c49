// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/evaluation_report.hpp"
#include "cli/evaluation_table.hpp"
#include "cli/scene_outcome.hpp"
#include "cli/shards.hpp"
#include "golden/error.hpp"
#include "io/file.hpp"
#include "report/page.hpp"

namespace trihedron::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  RecognitionArguments recognition;
  ShardArguments shard;
  std::string dataset, csv, features, report;
  std::vector<std::string> report_scenes = {"failed"};
  int jobs = 1;
  bool json = false, tables = false, quiet = false;
};

/// Before the work: a place that cannot be written must not cost the results.
void check_writable(const std::string& csv) {
  if (csv.empty()) return;
  const fs::path folder = fs::absolute(csv).parent_path();
  require_folder(folder, "a folder for --csv");
  if (fs::is_directory(csv)) throw Error(csv + ": --csv is a folder; expected a file name");
}

/// Nothing when only a shard was run.
std::optional<std::vector<SceneOutcome>> process(const Arguments& arguments,
                                                 const std::vector<fs::path>& scenes,
                                                 const std::vector<Model>& library) {
  const Recognizer recognizer(library);
  FrontEnd front_end;  // made in the worker: a simulation lives in one process
  report::HardwareActivity activity;
  const SceneRequest request{arguments.recognition,
                             arguments.features,
                             arguments.tables,
                             {!arguments.report.empty(), arguments.report_scenes}};
  const auto work = [&](std::size_t i) {
    if (!front_end) front_end = arguments.recognition.make_front_end(&activity);
    return to_text(process_scene(scenes[i], front_end, activity, recognizer, request));
  };
  const auto texts = run_sharded(scenes.size(), arguments.jobs, "scenes", arguments.shard, work);
  if (!texts) return std::nullopt;
  std::vector<SceneOutcome> outcomes;
  for (const std::string& text : *texts) outcomes.push_back(from_text(text));
  return outcomes;
}

int run(const Arguments& arguments) {
  const std::vector<fs::path> scenes = find_scenes(arguments.dataset);
  const std::vector<Model> library = arguments.recognition.library(arguments.dataset);
  check_writable(arguments.csv);
  report::check_report_file(arguments.report);
  check_report_scenes(arguments.report_scenes, scenes);
  if (!arguments.features.empty()) make_folder(arguments.features);
  const auto processed = process(arguments, scenes, library);
  if (!processed) return kDone;
  const std::vector<SceneOutcome>& outcomes = *processed;

  std::vector<ResultRow> rows;
  for (const SceneOutcome& outcome : outcomes)
    rows.insert(rows.end(), outcome.rows.begin(), outcome.rows.end());
  if (!arguments.csv.empty()) write_whole(arguments.csv, format_results(rows));
  if (!arguments.report.empty())
    write_evaluation_report(arguments.report, arguments.dataset, outcomes);
  for (const SceneOutcome& outcome : outcomes)
    if (!outcome.tables.empty()) fmt::print("{}\n", outcome.tables);
  if (!arguments.quiet)
    fmt::print("{}", arguments.json ? evaluation_json(outcomes) : evaluation_table(outcomes));
  return rows.empty() ? kNothingFound : kDone;
}

}  // namespace

void add_evaluate(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "evaluate", "Recognise every scene of a data set and hold the results against the truth");
  command
      ->add_option("DATASET", arguments->dataset,
                   "Folder of scenes in the BOP layout, up to two levels deep")
      ->required();
  arguments->recognition.add_to(*command);
  command->add_option("--csv", arguments->csv, "Write the results as BOP CSV")->type_name("FILE");
  command->add_option("--jobs", arguments->jobs, "Worker processes; the output stays the same")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      ->add_option("--features", arguments->features,
                   "Write SCENE/000000.png (contour) and SCENE/000000.csv (vertices) per view")
      ->type_name("DIR");
  auto* report =
      command
          ->add_option("--report", arguments->report,
                       "Write a page to look at: all scenes, and those that failed in full")
          ->type_name("FILE.html");
  command
      ->add_option("--report-scenes", arguments->report_scenes,
                   "Scenes that the page shows in full: failed, all, or names of scenes")
      ->type_name("SCENE")
      ->needs(report)
      ->capture_default_str();
  auto* json = command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command
      ->add_flag("--tables", arguments->tables,
                 "Print the source paper's tables 1-6 of every scene first (--method paper)")
      ->excludes(json);
  command->add_flag("--quiet", arguments->quiet, "Print no table");
  arguments->shard.add_to(*command);
  command->footer(
      "Example:\n"
      "  trihedron evaluate testvectors/scenes --models testvectors/models10 \\\n"
      "    --csv results.csv --jobs 2\n"
      "\n"
      "Right: the right model, every vertex within 20 % of its diameter, symmetries taken.\n"
      "AR: mean recall over 5, 10 .. 50 % of the diameter (BOP's MSSD).\n"
      "Exit code 1: no object was found in any scene.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace trihedron::cli
