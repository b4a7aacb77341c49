// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "recognition/camera.hpp"

namespace trihedron {

/// A plane n . x + d = 0 in the world frame, |n| = 1, mm.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;

  double distance(const Eigen::Vector3d& x) const { return normal.dot(x) + offset; }
};

/// A camera without distortion as one 3x4 matrix (pinhole or orthographic alike): image position
/// (P x) / (P x)_3 with homogeneous world positions. It goes with undistorted image positions.
class IdealView {
 public:
  explicit IdealView(const Camera& camera);

  /// Image position in px of a world point, mm. Pinhole: the point must lie in front.
  Eigen::Vector2d project(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d h = P_.leftCols<3>() * x + P_.col(3);
    return {h.x() / h.z(), h.y() / h.z()};
  }
  /// Depth in mm; 1 for every point of an orthographic view.
  double depth(const Eigen::Vector3d& x) const { return P_.row(2).head<3>().dot(x) + P_(2, 3); }
  /// The points that project onto the line through two image positions.
  Plane plane(const Eigen::Vector2d& p, const Eigen::Vector2d& q) const;
  /// The points that project onto an image position.
  Ray ray(const Eigen::Vector2d& p) const;
  /// Direction from the camera to a world point, not normalised.
  Eigen::Vector3d sight(const Eigen::Vector3d& x) const {
    return orthographic_ ? axis_ : Eigen::Vector3d(x - centre_);
  }
  const Eigen::Matrix<double, 3, 4>& matrix() const { return P_; }
  bool orthographic() const { return orthographic_; }
  /// Pinhole: where it stands. Orthographic: a point of its axis.
  const Eigen::Vector3d& centre() const { return centre_; }
  /// Unit, where it looks.
  const Eigen::Vector3d& axis() const { return axis_; }
  /// px that one mm across the line of sight covers at x.
  double px_per_mm(const Eigen::Vector3d& x) const { return scale_ / depth(x); }

 private:
  Eigen::Matrix<double, 3, 4> P_;
  bool orthographic_;
  Eigen::Vector3d centre_, axis_;  // pinhole: where it stands; both: where it looks
  Eigen::Matrix3d back_;           // image (homogeneous) to a direction or a foot point
  double scale_;                   // px per mm at depth 1
};

}  // namespace trihedron
