// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "io/scene.hpp"

namespace trihedron::bench {

inline std::filesystem::path models_folder() {
  return std::filesystem::path(TRIHEDRON_TESTVECTORS) / "models10";
}

/// The first scene of a kind, e.g. "lab-hd".
Scene scene_of_kind(const std::string& kind);

}  // namespace trihedron::bench
