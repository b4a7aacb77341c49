// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// A closed triangle mesh with its neighbourhoods. Half edge h = 3 * triangle + corner runs
/// from that corner to the next one; twin[h] is the same edge seen from the other triangle.
struct Topology {
  Mesh mesh;
  std::vector<int> twin;
  double tolerance = 0;  ///< mm, distance below which two positions of this mesh are one

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  int origin(int h) const { return mesh.triangles[h / 3][h % 3]; }
  int target(int h) const { return origin(next(h)); }
};

/// Welds equal vertices, turns the triangles to one orientation with the outside outwards and
/// links neighbours. `name` heads the messages. Throws Error as build_model does.
Topology build_topology(const std::string& name, const Mesh& mesh);

}  // namespace trihedron
