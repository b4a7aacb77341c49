// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "recognition/model_topology.hpp"

namespace trihedron {

/// The planar faces of a closed mesh: the surface index of each triangle, from 0 in the order
/// of each surface's first triangle. Throws Error when the faces are those of a curved part.
std::vector<int> merge_coplanar(const std::string& name, const Topology& topology);

/// The boundaries of each surface as vertex indices, surface on the left hand, with only the
/// vertices where the boundary bends or where three or more surfaces meet. The outer boundary
/// comes first. Throws Error when a surface has no outer boundary.
std::vector<std::vector<std::vector<int>>> surface_loops(const std::string& name,
                                                         const Topology& topology,
                                                         const std::vector<int>& surface_of);

/// Triangles that cover the polygon of `loops` (outer first, then holes), seen along -normal.
std::vector<std::array<int, 3>> triangulate(const std::vector<Eigen::Vector3d>& vertices,
                                            const std::vector<std::vector<int>>& loops,
                                            const Eigen::Vector3d& normal);

/// Twice the area vector of a closed boundary: its length is twice the area, its direction the
/// side from which the boundary runs counter-clockwise.
Eigen::Vector3d area_vector2(const std::vector<Eigen::Vector3d>& vertices,
                             const std::vector<int>& loop);

}  // namespace trihedron
