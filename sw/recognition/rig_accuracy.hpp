// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/camera.hpp"

namespace trihedron {

/// How well a set of cameras locates one point.
struct PointAccuracy {
  int views = 0;  ///< cameras that have the point in their image
  Eigen::Matrix3d covariance_mm2 = Eigen::Matrix3d::Zero();  ///< world
  double best_mm = 0;   ///< standard deviation along the best axis of the error's ellipsoid
  double worst_mm = 0;  ///< along the worst
  Eigen::Vector3d worst_axis = Eigen::Vector3d::Zero();  ///< world
};

/// The accuracy of `x_in_world` when each camera measures its image with independent errors of
/// `noise_px` (standard deviation, each axis): covariance = noise^2 (sum J'J)^-1 with J the
/// derivative of the image position by the point. Fewer than two views: no covariance.
PointAccuracy point_accuracy(const std::vector<Camera>& cameras, const Eigen::Vector3d& x_in_world,
                             double noise_px);

/// Largest angle between the lines of sight of two cameras at the point, rad, at most pi/2: a
/// quarter turn is best.
double widest_angle(const std::vector<Camera>& cameras, const Eigen::Vector3d& x_in_world);

/// The point nearest to the cameras' optical axes (least squares), where the rig looks.
Eigen::Vector3d rig_centre(const std::vector<Camera>& cameras);

}  // namespace trihedron
