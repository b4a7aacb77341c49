// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluation_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

namespace trihedron::cli {
namespace {

/// The figures of one kind of scene.
struct Line {
  std::string kind;
  int scenes = 0, with_truth = 0, results = 0;
  int objects = 0, right = 0, wrong = 0;
  int surfaces_described = 0, surfaces_right = 0;
  std::vector<double> recall, vertex_mm;
  std::vector<StageStatistics> stages;  ///< sums
};

void add(Line& line, const SceneOutcome& outcome) {
  ++line.scenes;
  line.results += static_cast<int>(outcome.rows.size());
  for (const StageStatistics& stage : outcome.stages) {
    auto at = std::find_if(line.stages.begin(), line.stages.end(),
                           [&](const StageStatistics& s) { return s.stage == stage.stage; });
    if (at == line.stages.end()) at = line.stages.insert(at, {stage.stage, 0, 0});
    at->count += stage.count;
    at->seconds += stage.seconds;
  }
  if (!outcome.has_truth) return;
  ++line.with_truth;
  line.wrong += outcome.score.wrong;
  line.surfaces_described += outcome.score.surfaces_described;
  line.surfaces_right += outcome.score.surfaces_right;
  for (const ObjectScore& object : outcome.score.objects) {
    ++line.objects;
    line.right += object.right ? 1 : 0;
    line.recall.push_back(object.recall);
    if (object.right) line.vertex_mm.push_back(object.vertex_mm);
  }
}

/// A line per kind in order of appearance, then one for all.
std::vector<Line> summarise(const std::vector<SceneOutcome>& outcomes) {
  std::vector<Line> lines;
  Line all;
  all.kind = "all";
  for (const SceneOutcome& outcome : outcomes) {
    auto at = std::find_if(lines.begin(), lines.end(),
                           [&](const Line& line) { return line.kind == outcome.kind; });
    if (at == lines.end()) {
      at = lines.insert(at, Line());
      at->kind = outcome.kind;
    }
    add(*at, outcome);
    add(all, outcome);
  }
  lines.push_back(all);
  return lines;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string percent(int part, int whole) {
  return whole == 0 ? "-" : fmt::format("{:.1f}", 100.0 * part / whole);
}

std::string results_line(const Line& line) {
  const bool errors = !line.vertex_mm.empty();
  const bool surfaces = line.surfaces_described > 0;  // only some methods describe surfaces
  return fmt::format("{:<18} {:>6} {:>7} {:>5} {:>5} {:>7} {:>6}  {:>6} {:>6}  {:>9} {:>5} {:>7}\n",
                     line.kind, line.scenes, line.objects, line.right, line.wrong,
                     percent(line.right, line.objects),
                     line.recall.empty() ? "-" : fmt::format("{:.3f}", mean(line.recall)),
                     errors ? fmt::format("{:.2f}", mean(line.vertex_mm)) : "-",
                     errors ? fmt::format("{:.2f}", median(line.vertex_mm)) : "-",
                     surfaces ? std::to_string(line.surfaces_described) : "-",
                     surfaces ? std::to_string(line.surfaces_right) : "-",
                     percent(line.surfaces_right, line.surfaces_described));
}

std::string results_table(const std::vector<Line>& lines) {
  std::string out = fmt::format("{:<18} {:>6} {:>7} {:>5} {:>5} {:>7} {:>6}  {:>13}  {:>23}\n", "",
                                "", "", "", "", "right", "", "vertex err mm", "surfaces");
  out += fmt::format("{:<18} {:>6} {:>7} {:>5} {:>5} {:>7} {:>6}  {:>6} {:>6}  {:>9} {:>5} {:>7}\n",
                     "set", "scenes", "objects", "right", "wrong", "%", "AR", "mean", "median",
                     "described", "right", "%");
  for (const Line& line : lines) out += results_line(line);
  return out;
}

std::string time_table(const std::vector<Line>& lines) {
  std::string out = fmt::format("\n{:<18}", "ms per scene");
  for (const StageStatistics& stage : lines.back().stages)
    out += fmt::format(" {:>11}", stage.stage);
  out += fmt::format(" {:>11}\n", "software");
  for (const Line& line : lines) {
    out += fmt::format("{:<18}", line.kind);
    double software = 0;
    for (const StageStatistics& stage : lines.back().stages) {
      const auto at =
          std::find_if(line.stages.begin(), line.stages.end(),
                       [&](const StageStatistics& s) { return s.stage == stage.stage; });
      const double ms = at == line.stages.end() ? 0 : 1e3 * at->seconds / line.scenes;
      if (stage.stage != "front end") software += ms;
      out += fmt::format(" {:>11.2f}", ms);
    }
    out += fmt::format(" {:>11.2f}\n", software);
  }
  return out;
}

}  // namespace

std::string evaluation_table(const std::vector<SceneOutcome>& outcomes) {
  const std::vector<Line> lines = summarise(outcomes);
  if (lines.back().with_truth > 0) return results_table(lines) + time_table(lines);
  return fmt::format("{} scenes without scene_gt.json, {} objects found\n", lines.back().scenes,
                     lines.back().results) +
         time_table(lines);
}

std::string evaluation_json(const std::vector<SceneOutcome>& outcomes) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Line& line : summarise(outcomes)) {
    nlohmann::ordered_json entry = {{"set", line.kind},
                                    {"scenes", line.scenes},
                                    {"results", line.results},
                                    {"objects", line.objects},
                                    {"right", line.right},
                                    {"wrong", line.wrong},
                                    {"ar", nullptr},
                                    {"vertex_mean_mm", nullptr},
                                    {"vertex_median_mm", nullptr},
                                    {"surfaces_described", line.surfaces_described},
                                    {"surfaces_right", line.surfaces_right}};
    if (!line.recall.empty()) entry["ar"] = mean(line.recall);
    if (!line.vertex_mm.empty()) {
      entry["vertex_mean_mm"] = mean(line.vertex_mm);
      entry["vertex_median_mm"] = median(line.vertex_mm);
    }
    for (const StageStatistics& stage : line.stages)
      entry["ms_per_scene"][stage.stage] = 1e3 * stage.seconds / line.scenes;
    out.push_back(entry);
  }
  return out.dump(1) + "\n";
}

}  // namespace trihedron::cli
