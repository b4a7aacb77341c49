// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "recognition/model.hpp"

namespace trihedron {

/// Whether the file's name ends like a mesh that read_mesh knows: ply, obj, stl, off.
bool is_mesh_name(const std::filesystem::path& file);

/// The triangles of a mesh file (PLY, OBJ, STL, OFF; polygons are cut into triangles), mm, in
/// the file's order. Throws Error when the file is missing or unreadable.
Mesh read_mesh(const std::filesystem::path& file);

/// Writes the mesh as ASCII PLY, mm, with the digits that read back the same doubles.
void write_ply(const std::filesystem::path& file, const Mesh& mesh);

}  // namespace trihedron
