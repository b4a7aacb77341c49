// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// Faces as mesh files hold them: planar polygons, counter-clockwise seen from outside.
struct Polygons {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> faces;  ///< vertex indices; at least three each
};

/// Each polygon cut into triangles, concave ones too; triangles stay as they are. Throws Error,
/// headed by `name`, when a face uses a vertex that is not there.
Mesh triangulate(const std::string& name, const Polygons& polygons);

// Own code: Assimp 5.2 crashes, hangs or leaks on broken files (docs/decisions.md). All throw Error
// with what is wrong.

/// Reads a PLY file, ASCII or binary.
Polygons read_ply(const std::filesystem::path& file);

/// Reads an STL file, binary or ASCII: triangles, each with corners of its own.
Polygons read_stl(const std::filesystem::path& file);

/// Reads the faces of an OBJ file; its materials, normals and groups are skipped.
Polygons read_obj(const std::filesystem::path& file);

/// Reads an OFF file: header OFF (or COFF, NOFF ... whose extra numbers are skipped), counts,
/// vertices, faces; comments and blank lines anywhere.
Polygons read_off(const std::filesystem::path& file);

}  // namespace trihedron
