// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "recognition/transform.hpp"

namespace trihedron {

/// A half line in the world frame: origin + s * direction, s >= 0 mm, |direction| = 1.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
};

/// A calibrated view. Camera frame: x right, y down, z forward, mm. Image frame: origin at the
/// centre of the top left pixel, x right, y down, px.
struct Camera {
  enum class Projection { kPinhole, kOrthographic };

  std::string view;  ///< "top", "side", "front" or any other name
  Projection projection = Projection::kPinhole;
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();  ///< px; orthographic uses only cx, cy
  std::array<double, 5> distortion{};               ///< OpenCV's k1 k2 p1 p2 k3
  double px_per_mm = 0;                             ///< orthographic only
  Transform camera_from_world;
  int width_px = 0;
  int height_px = 0;

  /// Image position in px of a point in the camera frame, mm (distortion included). Pinhole
  /// points must lie in front of the camera (z > 0).
  Eigen::Vector2d project_camera(const Eigen::Vector3d& x_in_camera) const;
  /// Image position in px of a point in the world frame, mm.
  Eigen::Vector2d project(const Eigen::Vector3d& x_in_world) const;
  /// Derivative of project() by the point: px per mm along the world's axes.
  Eigen::Matrix<double, 2, 3> projection_jacobian(const Eigen::Vector3d& x_in_world) const;
  /// The ray, in the world frame, of the points that project onto `pixel`.
  Ray ray(const Eigen::Vector2d& pixel) const;
  /// Distance in px that one mm covers at `x_in_world`, across the line of sight.
  double px_per_mm_at(const Eigen::Vector3d& x_in_world) const;
  /// `pixel` with the lens distortion taken out: where an ideal camera with the same K sees it.
  Eigen::Vector2d undistort(const Eigen::Vector2d& pixel) const;
};

}  // namespace trihedron
