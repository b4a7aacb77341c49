// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "recognition/transform.hpp"

namespace trihedron {

/// A triangle mesh, mm, triangles counter-clockwise seen from outside.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// A planar face of a model: coplanar connected triangles merged.
struct Surface {
  Eigen::Vector3d normal;    ///< unit, outwards
  double offset = 0;         ///< normal . x = offset for x in the surface, mm
  double area = 0;           ///< mm^2
  double perimeter = 0;      ///< mm, inner boundaries included
  Eigen::Vector3d centroid;  ///< of the area, mm
  std::vector<std::vector<int>> loops;  ///< vertex indices; loops[0] outer, counter-clockwise seen
                                        ///< from outside; the others holes, clockwise
  std::vector<int> triangles;           ///< indices into the mesh
};

/// A straight edge between two surfaces.
struct ModelEdge {
  int v0 = 0, v1 = 0;            ///< vertex indices
  int left = 0, right = 0;       ///< surfaces: `left` runs v0 -> v1 counter-clockwise
  double length = 0;             ///< mm
  bool convex = true;            ///< the solid bulges outwards at this edge
};

/// A polyhedral model and the attributes that recognition needs, computed once.
struct Model {
  int id = 0;
  std::string name;
  Mesh mesh;  ///< vertices that lie inside a surface or on a straight edge are merged away
  std::vector<Surface> surfaces;
  std::vector<ModelEdge> edges;
  std::vector<std::vector<int>> vertex_edges;  ///< per vertex: the edges that meet there
  std::vector<Transform> symmetries;  ///< proper motions that map the model onto itself, without
                                      ///< the identity
  double diameter = 0;                ///< largest distance of two vertices, mm
};

/// Builds the model of a closed polyhedral mesh. Throws Error when the mesh is empty, is not
/// closed or not manifold (naming the edge), is inside out beyond repair, or has so many small
/// surfaces that it is curved.
Model build_model(int id, const std::string& name, const Mesh& mesh);

}  // namespace trihedron
