// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_outcome.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cli/paper_tables.hpp"
#include "io/feature_files.hpp"
#include "report/scene_data.hpp"

namespace trihedron::cli {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

json to_json(const ResultRow& row) {
  const Transform& pose = row.camera_from_model;
  return {row.scene_id,
          row.im_id,
          row.model_id,
          row.score,
          row.seconds,
          std::vector<double>(pose.R.data(), pose.R.data() + 9),
          std::vector<double>(pose.t.data(), pose.t.data() + 3)};
}

ResultRow row_from_json(const json& j) {
  ResultRow row{j[0], j[1], j[2], j[3], {}, j[4]};
  for (int i = 0; i < 9; ++i) row.camera_from_model.R.data()[i] = j[5][i];
  for (int i = 0; i < 3; ++i) row.camera_from_model.t[i] = j[6][i];
  return row;
}

bool in_full(const std::vector<std::string>& choices, const report::RecognizedScene& recognized) {
  return std::any_of(choices.begin(), choices.end(), [&](const std::string& choice) {
    return choice == "all" || choice == recognized.scene.name ||
           (choice == "failed" && report::failed(recognized));
  });
}

std::string report_text(const report::RecognizedScene& recognized, const ReportRequest& request) {
  const bool full = in_full(request.scenes, recognized);
  const report::Json out = {{"line", report::scene_line(recognized)},
                            {"scene", full ? report::scene_data(recognized) : report::Json()}};
  return out.dump(-1, ' ', false, report::Json::error_handler_t::replace);
}

}  // namespace

SceneOutcome process_scene(const std::filesystem::path& folder, const FrontEnd& front_end,
                           const report::HardwareActivity& activity, const Recognizer& recognizer,
                           const SceneRequest& request) {
  const std::vector<Model>& library = recognizer.library();
  const Scene scene = read_scene(folder);
  SceneOutcome outcome;
  outcome.kind = scene.kind.empty() ? "scenes" : scene.kind;
  auto start = Clock::now();
  const std::vector<View> views = make_views(scene, front_end);
  int vertices = 0;
  for (const View& view : views) vertices += static_cast<int>(view.features.vertices.size());
  outcome.stages.push_back({"front end", vertices, seconds_since(start)});
  if (!request.features_folder.empty())
    for (std::size_t v = 0; v < views.size(); ++v)
      write_features(std::filesystem::path(request.features_folder) / scene.name, scene.im_ids[v],
                     views[v].features);
  start = Clock::now();
  const RecognitionResult result =
      recognize_with_tables(scene.name, views, recognizer, request.recognition.options(),
                            request.tables ? &outcome.tables : nullptr);
  outcome.rows = result_rows(scene, result, seconds_since(start));
  outcome.stages.insert(outcome.stages.end(), result.stages.begin(), result.stages.end());
  outcome.has_truth = scene.truth.has_value();
  if (scene.truth) outcome.score = score_scene(result, *scene.truth, library);
  if (request.report.wanted)
    outcome.report = report_text({scene, views, library, result, request.recognition.front_end,
                                  request.recognition.method, activity},
                                 request.report);
  return outcome;
}

std::string to_text(const SceneOutcome& outcome) {
  json rows = json::array(), stages = json::array(), objects = json::array();
  for (const ResultRow& row : outcome.rows) rows.push_back(to_json(row));
  for (const StageStatistics& s : outcome.stages) stages.push_back({s.stage, s.count, s.seconds});
  for (const ObjectScore& o : outcome.score.objects)
    objects.push_back({o.right, o.recall, o.vertex_mm});
  const json out = {
      {"kind", outcome.kind},
      {"has_truth", outcome.has_truth},
      {"rows", rows},
      {"tables", outcome.tables},
      {"report", outcome.report},
      {"stages", stages},
      {"objects", objects},
      {"counts",
       {outcome.score.wrong, outcome.score.surfaces_described, outcome.score.surfaces_right}}};
  return out.dump();
}

SceneOutcome from_text(const std::string& text) {
  const json in = json::parse(text);
  SceneOutcome outcome;
  outcome.kind = in["kind"];
  outcome.has_truth = in["has_truth"];
  outcome.tables = in["tables"];
  outcome.report = in["report"];
  for (const json& row : in["rows"]) outcome.rows.push_back(row_from_json(row));
  for (const json& s : in["stages"]) outcome.stages.push_back({s[0], s[1], s[2]});
  for (const json& o : in["objects"]) outcome.score.objects.push_back({o[0], o[1], o[2]});
  outcome.score.wrong = in["counts"][0];
  outcome.score.surfaces_described = in["counts"][1];
  outcome.score.surfaces_right = in["counts"][2];
  return outcome;
}

}  // namespace trihedron::cli
