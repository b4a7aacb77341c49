// SPDX-License-Identifier: Apache-2.0
#include "sim/registers.hpp"

#include <algorithm>
#include <string>

#include "golden/registers.hpp"

namespace trihedron::sim {

namespace {

std::uint32_t value(int number) { return static_cast<std::uint32_t>(number); }

std::vector<RegisterValue> threshold_settings(const golden::FrontEndConfig& thresholds,
                                              int vertex_limit) {
  return {
      {"VERTEX_LIMIT", registers::kVertexLimit, value(vertex_limit)},
      {"NOISE_FLOOR", registers::kNoiseFloor, value(thresholds.first_contour.noise_floor)},
      {"MEAN_LIMIT", registers::kMeanLimit, value(thresholds.first_contour.mean_limit)},
      {"SUPPORT", registers::kSupport, value(thresholds.second_contour.support)},
      {"BRANCH_FLOOR", registers::kBranchFloor, value(thresholds.vertices.branch_floor)},
      {"MIN_TURN", registers::kMinTurn, value(thresholds.vertices.min_turn)},
  };
}

}  // namespace

std::vector<RegisterValue> change_settings(const SettingsChange& change) {
  std::vector<RegisterValue> settings = threshold_settings(change.thresholds, change.vertex_limit);
  settings.push_back({"FRAME_HEIGHT", registers::kFrameHeight, value(change.frame_height)});
  // A hold comes before what it holds, a release after it.
  settings.insert(
      change.held ? settings.begin() : settings.end(),
      {"CONTROL", registers::kControl,
       registers::kControlEnable.put(change.enabled) | registers::kControlHold.put(change.held)});
  return settings;
}

std::vector<int> first_alike(const std::vector<SettingsChange>& settings) {
  const auto alike = [](const SettingsChange& a, const SettingsChange& b) {
    const auto left = threshold_settings(a.thresholds, a.vertex_limit);
    const auto right = threshold_settings(b.thresholds, b.vertex_limit);
    return std::equal(left.begin(), left.end(), right.begin(),
                      [](const auto& x, const auto& y) { return x.value == y.value; });
  };
  std::vector<int> numbers;
  for (const SettingsChange& one : settings) {
    const auto first = std::find_if(settings.begin(), settings.end(),
                                    [&](const SettingsChange& other) { return alike(other, one); });
    numbers.push_back(static_cast<int>(first - settings.begin()));
  }
  return numbers;
}

std::vector<RegisterValue> run_settings(const RunOptions& options) {
  std::vector<RegisterValue> settings =
      threshold_settings(options.thresholds, options.vertex_limit);
  settings.push_back({"FRAME_HEIGHT", registers::kFrameHeight, value(options.frame_height)});
  settings.push_back({"FLUSH_TIMEOUT", registers::kFlushTimeout, value(options.flush_timeout)});
  return settings;
}

std::vector<RegisterValue> final_values(const RunOptions& options, const Report& report) {
  std::vector<RegisterValue> values =
      options.changes.empty() ? run_settings(options) : change_settings(options.changes.back());
  values.push_back({"ID", registers::kId, registers::kIdId.reset});
  for (std::size_t view = 0; view < kViews; ++view) {
    const ViewStatistics& count = report.views[view];
    const std::string of_view = " of view " + std::to_string(view);
    const auto add = [&](const char* name, std::uint32_t address, std::uint64_t value) {
      values.push_back({name + of_view,
                        address + registers::kViewStride * static_cast<std::uint32_t>(view),
                        static_cast<std::uint32_t>(value)});
    };
    add("FRAMES", registers::kFrames, count.frames);
    add("VERTICES", registers::kVertices, count.vertices);
    add("LOST", registers::kLost, count.vertices_lost);
    add("ERRORS", registers::kErrors, count.stream_errors & 0xffff);
    add("LAST_FRAME", registers::kLastFrame, count.last_vertices | count.last_vertices_lost << 16);
  }
  return values;
}

RegisterValue status_value(int view, const ViewStatistics& count) {
  return {"STATUS of view " + std::to_string(view),
          registers::kStatus + registers::kViewStride * static_cast<std::uint32_t>(view),
          count.stream_error_kinds | registers::kStatusVerticesLost.put(count.vertices_lost != 0)};
}

}  // namespace trihedron::sim
