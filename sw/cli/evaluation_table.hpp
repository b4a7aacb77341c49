// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/scene_outcome.hpp"

namespace trihedron::cli {

/// Two tables for people, a line per kind of scene and one for all: objects right and wrong,
/// vertex error, surfaces described and right; then the time of each stage.
std::string evaluation_table(const std::vector<SceneOutcome>& outcomes);

/// The same figures as JSON.
std::string evaluation_json(const std::vector<SceneOutcome>& outcomes);

}  // namespace trihedron::cli
