// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recognition/camera.hpp"

namespace trihedron {

/// The three orthogonal views of the paper, in its order of priority.
enum class ViewRole { kTop = 0, kSide = 1, kFront = 2 };

/// A view that measures two world coordinates of a point, to one scale for all depths (scaled
/// orthographic, eq. 1). Top: x and y; side: x and z; front: y and z.
struct PlanarView {
  int view = 0;  ///< index of the camera
  ViewRole role = ViewRole::kTop;
  Camera camera;
  double mm_per_px = 0;                  ///< at the table centre
  Eigen::Vector3d table_centre;          ///< world, mm
  Eigen::Vector2d table_centre_px;       ///< where an ideal camera sees it
  Eigen::Vector3d right, down, towards;  ///< unit, world: the image axes, and to the camera

  /// What the view measures of the point seen at `pixel` (distortion included): the world point,
  /// mm, in the plane through the table centre across the line of sight.
  Eigen::Vector3d measure(const Eigen::Vector2d& pixel) const;
};

/// The views in the order top, side, front. A view's role is the world axis nearest to its line
/// of sight: z top, y side, x front. The table centre is where the top camera's line of sight
/// meets z = 0. Throws Error when one of the three is missing or there twice.
std::array<PlanarView, 3> planar_views(const std::vector<Camera>& cameras);

/// The table's lower left corner, the paper's world origin: smallest x and y in the top view's
/// image, z = 0, mm.
Eigen::Vector3d table_corner(const PlanarView& top);

}  // namespace trihedron
