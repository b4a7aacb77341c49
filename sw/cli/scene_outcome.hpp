// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/recognition_options.hpp"
#include "io/bop_results.hpp"
#include "recognition/evaluation.hpp"

namespace trihedron::cli {

/// What evaluate keeps of a scene.
struct SceneOutcome {
  std::string kind;  ///< the set it is counted in
  bool has_truth = false;
  SceneScore score;  ///< empty without truth
  std::vector<ResultRow> rows;
  std::vector<StageStatistics> stages;  ///< "front end" first
  std::string tables;                   ///< the paper's, if asked for
};

/// Reads and recognises a scene; writes its features below `features_folder` unless "".
/// `tables`: fills in SceneOutcome::tables, method paper only.
SceneOutcome process_scene(const std::filesystem::path& folder, const FrontEnd& front_end,
                           const std::vector<Model>& library, const RecognitionOptions& options,
                           const std::string& features_folder, bool tables);

/// An outcome as text and back without loss, to hand it from one process to another.
std::string to_text(const SceneOutcome& outcome);
SceneOutcome from_text(const std::string& text);

}  // namespace trihedron::cli
