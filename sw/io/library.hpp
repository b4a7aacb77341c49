// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// The models of a folder of meshes, by id. obj_000007.ply has id 7; meshes with other names get
/// the next free ids in the order of their names. Names come from models_names.json, else from
/// the file. Where models_info.json gives diameters they must agree.
///
/// Throws Error with the file: no mesh in the folder, a mesh that build_model refuses, an id or a
/// shape that occurs twice, a diameter that disagrees (wrong unit).
std::vector<Model> read_library(const std::filesystem::path& folder);

}  // namespace trihedron
