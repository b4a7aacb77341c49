// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <chrono>
#include <memory>

#include "cli/commands.hpp"
#include "cli/paper_tables.hpp"
#include "cli/recognition_options.hpp"
#include "cli/recognize_stream.hpp"
#include "cli/terminal.hpp"
#include "golden/error.hpp"
#include "io/bop_results.hpp"
#include "io/file.hpp"
#include "io/pictures.hpp"
#include "io/report_json.hpp"
#include "report/page.hpp"
#include "report/scene_data.hpp"

namespace trihedron::cli {
namespace {

struct Arguments {
  RecognitionArguments recognition;
  StreamArguments stream;
  std::string scene, out, report;
  bool json = false, tables = false, quiet = false;
};

const Model& model_of(const std::vector<Model>& library, int id) {
  for (const Model& model : library)
    if (model.id == id) return model;
  return library.front();
}

void print_object(const RecognizedObject& object, const std::vector<Model>& library) {
  constexpr double kDegrees = 180 / 3.14159265358979323846;
  const Eigen::AngleAxisd turn(object.world_from_model.R);
  const Eigen::Vector3d r = turn.angle() * kDegrees * turn.axis();
  const Eigen::Vector3d& t = object.world_from_model.t;
  fmt::print("{:<18} {:6.3f}  {:8.2f} {:8.2f} {:8.2f}  {:7.1f} {:7.1f} {:7.1f}  {:5.2f}  {:3}",
             model_of(library, object.model_id).name, object.score, t.x(), t.y(), t.z(), r.x(),
             r.y(), r.z(), object.reprojection_rms_px, object.surfaces.size());
  if (object.runner_up_model_id >= 0)
    fmt::print("  {} {:.3f}", model_of(library, object.runner_up_model_id).name,
               object.runner_up_score);
  fmt::print("\n");
}

void print_result(const Scene& scene, const RecognitionResult& result,
                  const std::vector<Model>& library) {
  if (result.objects.empty()) {
    fmt::print("scene {}: no object of the library found\n", scene.name);
  } else {
    const std::string heading =
        fmt::format("{:<18} {:>6}  {:>26}  {:>23}  {:>5}  {:>3}  {}", "object", "score",
                    "position in world, mm", "rotation vector, deg", "px", "srf", "runner-up");
    fmt::print("{}\n", toned(stdout, Tone::kHeading, heading));
    for (const RecognizedObject& object : result.objects) print_object(object, library);
  }
  constexpr std::size_t kShown = 5;
  for (std::size_t i = 0; i < std::min(kShown, result.rejections.size()); ++i)
    fmt::print("rejected: {} ({:.3f}): {}\n", model_of(library, result.rejections[i].model_id).name,
               result.rejections[i].score, result.rejections[i].reason);
  if (result.rejections.size() > kShown)
    fmt::print("rejected: {} more, see --json\n", result.rejections.size() - kShown);
  for (const StageStatistics& stage : result.stages)
    fmt::print("{:<12} {:6}  {:8.2f} ms\n", stage.stage, stage.count, 1e3 * stage.seconds);
}

/// Everything that was asked for as files; `json` is the report for machines.
void write_files(const Arguments& arguments, const report::RecognizedScene& done,
                 const std::string& json, double seconds) {
  if (!arguments.out.empty()) {
    const std::filesystem::path out = arguments.out;
    write_pictures(out, done.scene, done.views, done.result, done.library);
    write_whole(out / "results.csv", format_results(result_rows(done.scene, done.result, seconds)));
    write_whole(out / "report.json", json);
  }
  if (arguments.report.empty()) return;
  report::PageContent content;
  content.title = "Scene " + done.scene.name;
  content.program = "trihedron " TRIHEDRON_VERSION;
  content.scenes.push_back(report::scene_data(done));
  write_whole(arguments.report, report::make_page(content));
}

int run_scene(const Arguments& arguments) {
  const RecognitionArguments& options = arguments.recognition;
  const Scene scene = read_scene(arguments.scene);
  const std::vector<Model> library = options.library(arguments.scene);
  if (!arguments.out.empty()) make_folder(arguments.out);
  report::check_report_file(arguments.report);
  report::HardwareActivity activity;
  const std::vector<View> views = make_views(scene, options.make_front_end(&activity));
  const auto start = std::chrono::steady_clock::now();
  std::string tables;
  const RecognitionResult result =
      recognize_with_tables(scene.name, views, Recognizer(library), options.options(),
                            arguments.tables ? &tables : nullptr);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const std::string json = report_json(scene, result, library).dump(1) + "\n";
  write_files(arguments,
              {scene, views, library, result, options.front_end, options.method, activity}, json,
              seconds.count());
  if (arguments.json)
    fmt::print("{}", json);
  else if (arguments.tables)
    fmt::print("{}", tables);
  else if (!arguments.quiet)
    print_result(scene, result, library);
  return result.objects.empty() ? kNothingFound : kDone;
}

int run(const Arguments& arguments) {
  const bool stream = !arguments.stream.sources.empty();
  if (stream && !arguments.report.empty())
    throw Error("--report: not with --stream; expected a SCENE, whose page it writes");
  if (stream)
    return recognize_stream(arguments.stream, arguments.recognition, arguments.out,
                            arguments.quiet);
  if (arguments.scene.empty())
    throw Error("recognize: SCENE is required; expected the folder of a scene, or --stream");
  return run_scene(arguments);
}

}  // namespace

void add_recognize(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("recognize", "Which objects are in a scene, and where");
  CLI::Option* scene =
      command->add_option("SCENE", arguments->scene,
                          "Folder with scene_camera.json and gray/000000.png ... (BOP layout)");
  arguments->stream.add_to(*command);
  command->get_option("--stream")->excludes(scene);
  arguments->recognition.add_to(*command);
  command
      ->add_option("--out", arguments->out,
                   "Write pictures of every stage and view, results.csv and report.json here; with "
                   "--stream results.jsonl")
      ->type_name("DIR");
  command
      ->add_option("--report", arguments->report,
                   "Write a page to look at: every stage in every view, the scene in space, tables")
      ->type_name("FILE.html");
  command->add_flag("--json", arguments->json, "Print the whole report as JSON");
  command->add_flag("--tables", arguments->tables,
                    "Print the source paper's tables 1-6 instead (--method paper)");
  command->add_flag("--quiet", arguments->quiet, "Print nothing; the exit code and --out tell");
  command->footer(
      "Examples:\n"
      "  trihedron recognize testvectors/scenes/studio-two/000034 \\\n"
      "    --models testvectors/models10 --out out/000034 --report out/000034.html\n"
      "  trihedron recognize --stream top.mp4 side.mp4 front.mp4 \\\n"
      "    --cameras scene_camera.json --models parts --out out/stream\n"
      "\n"
      "Exit code 1: no object of the library was found. Ctrl-C ends a stream after the frame in\n"
      "work, writes what was done and returns 130.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace trihedron::cli
