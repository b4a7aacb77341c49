// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/recognition_options.hpp"
#include "io/bop_results.hpp"
#include "recognition/evaluation.hpp"
#include "recognition/recognizer.hpp"

namespace trihedron::cli {

/// What evaluate keeps of a scene.
struct SceneOutcome {
  std::string kind;  ///< the set it is counted in
  bool has_truth = false;
  SceneScore score;  ///< empty without truth
  std::vector<ResultRow> rows;
  std::vector<StageStatistics> stages;  ///< "front end" first
  std::string tables;                   ///< the paper's, if asked for
  std::string report;  ///< JSON, if asked for: "line" and "scene" (or null) of a page
};

/// What a page shall show of a scene besides its line in the overview.
struct ReportRequest {
  bool wanted = false;
  std::vector<std::string> scenes;  ///< shown in full: "failed", "all", or names of scenes
};

/// What is to be done with a scene.
struct SceneRequest {
  const RecognitionArguments& recognition;
  std::string features_folder;  ///< write the features below it, "": do not
  bool tables = false;          ///< fill in SceneOutcome::tables, method paper only
  ReportRequest report;
};

/// Reads and recognises a scene. `activity` is where `front_end` stores what it counts.
SceneOutcome process_scene(const std::filesystem::path& folder, const FrontEnd& front_end,
                           const report::HardwareActivity& activity, const Recognizer& recognizer,
                           const SceneRequest& request);

/// An outcome as text and back without loss, to hand it from one process to another.
std::string to_text(const SceneOutcome& outcome);
SceneOutcome from_text(const std::string& text);

}  // namespace trihedron::cli
