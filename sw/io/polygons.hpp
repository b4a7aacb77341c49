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

/// Reads a PLY file, ASCII or binary. Own code, since Assimp 5.2 crashes or hangs on broken ones.
/// Throws Error with what is wrong.
Polygons read_ply(const std::filesystem::path& file);

/// Reads an OFF file: header OFF (or COFF, NOFF ... whose extra numbers are skipped), counts,
/// vertices, faces; comments and blank lines anywhere. Own code, since Assimp 5.2 loses as many
/// faces as there are comment lines. Throws Error with the line that is wrong.
Polygons read_off(const std::filesystem::path& file);

}  // namespace trihedron
