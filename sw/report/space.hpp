// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/evaluation.hpp"
#include "recognition/visibility.hpp"
#include "report/json_numbers.hpp"

namespace trihedron::report {

// What stands in the world frame, mm, for a drawing in three dimensions. Lists of points are flat:
// x, y, z, x, y, z ...

/// The point nearest to the axes of all cameras: what the rig looks at.
Eigen::Vector3d looked_at(const std::vector<Camera>& cameras);

/// A camera: name, axis, distance to `focus` along it, and the rays of its picture's corners (top
/// left, top right, bottom right, bottom left) as origins and directions of depth 1.
Json space_camera(const Camera& camera, const Eigen::Vector3d& focus);

/// A model where it stands: vertices, triangles (three vertex indices each), the surface of each
/// triangle, edges (two vertex indices each).
Json space_model(const PlacedModel& placed);

/// Edges that views agreed on before any model was tried: {"line": two points, "views": how many
/// show it, "ends": how many of its ends two views agree on}.
Json space_edges(const std::vector<SpaceEdge>& edges);

}  // namespace trihedron::report
