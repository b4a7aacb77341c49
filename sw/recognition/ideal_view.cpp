// SPDX-License-Identifier: Apache-2.0
#include "recognition/ideal_view.hpp"

#include <Eigen/LU>
#include <cmath>

namespace trihedron {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

IdealView::IdealView(const Camera& camera)
    : orthographic_(camera.projection == Camera::Projection::kOrthographic) {
  const Transform& c = camera.camera_from_world;
  axis_ = c.R.row(2).transpose();
  centre_ = -(c.R.transpose() * c.t);
  if (orthographic_) {
    scale_ = camera.px_per_mm;
    P_.row(0) << scale_ * c.R.row(0), scale_ * c.t.x() + camera.K(0, 2);
    P_.row(1) << scale_ * c.R.row(1), scale_ * c.t.y() + camera.K(1, 2);
    P_.row(2) << 0, 0, 0, 1;
    Matrix3d M = P_.leftCols<3>();
    M.row(2) = c.R.row(2);
    back_ = M.inverse();
  } else {
    scale_ = std::sqrt(std::abs(camera.K(0, 0) * camera.K(1, 1)));
    P_.leftCols<3>() = camera.K * c.R;
    P_.col(3) = camera.K * c.t;
    back_ = (camera.K * c.R).inverse();
  }
}

Plane IdealView::plane(const Vector2d& p, const Vector2d& q) const {
  const Vector3d line = p.homogeneous().cross(q.homogeneous());
  const Eigen::Vector4d v = P_.transpose() * line;
  const double norm = v.head<3>().norm();
  return {v.head<3>() / norm, v.w() / norm};
}

Ray IdealView::ray(const Vector2d& p) const {
  if (orthographic_) {
    // The point of the line of sight in the plane through the camera, z = 0 there.
    const Vector3d shifted(p.x() - P_(0, 3), p.y() - P_(1, 3), axis_.dot(centre_));
    return {back_ * shifted, axis_};
  }
  return {centre_, (back_ * p.homogeneous()).normalized()};
}

}  // namespace trihedron
