// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/scene_outcome.hpp"

namespace trihedron::cli {

/// Throws Error unless each choice is "failed", "all" or the name of one of the scenes.
void check_report_scenes(const std::vector<std::string>& choices,
                         const std::vector<std::filesystem::path>& scenes);

/// Writes the page of an evaluation from the outcomes' reports. Scenes in full that would make it
/// too large for a browser are left out; the page says how many.
void write_evaluation_report(const std::string& file, const std::string& dataset,
                             const std::vector<SceneOutcome>& outcomes);

}  // namespace trihedron::cli
