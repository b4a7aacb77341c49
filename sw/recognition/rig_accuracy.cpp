// SPDX-License-Identifier: Apache-2.0
#include "recognition/rig_accuracy.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool sees(const Camera& camera, const Vector3d& x) {
  if (camera.projection == Camera::Projection::kPinhole && (camera.camera_from_world * x).z() <= 0)
    return false;
  const Eigen::Vector2d p = camera.project(x);
  return p.x() >= 0 && p.y() >= 0 && p.x() <= camera.width_px - 1 && p.y() <= camera.height_px - 1;
}

/// Towards the point, world.
Vector3d line_of_sight(const Camera& camera, const Vector3d& x) {
  if (camera.projection == Camera::Projection::kOrthographic)
    return camera.camera_from_world.R.row(2);
  return (x - camera.camera_from_world.inverse().t).normalized();
}

}  // namespace

PointAccuracy point_accuracy(const std::vector<Camera>& cameras, const Vector3d& x_in_world,
                             double noise_px) {
  PointAccuracy out;
  Matrix3d information = Matrix3d::Zero();
  for (const Camera& camera : cameras) {
    if (!sees(camera, x_in_world)) continue;
    ++out.views;
    const Eigen::Matrix<double, 2, 3> J = camera.projection_jacobian(x_in_world);
    information += J.transpose() * J;
  }
  if (out.views < 2) return out;
  out.covariance_mm2 = noise_px * noise_px * information.inverse();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(out.covariance_mm2);  // ascending
  out.best_mm = std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
  out.worst_mm = std::sqrt(axes.eigenvalues()[2]);
  out.worst_axis = axes.eigenvectors().col(2);
  return out;
}

double widest_angle(const std::vector<Camera>& cameras, const Vector3d& x_in_world) {
  double least = 1;  // cosine
  for (const Camera& a : cameras)
    for (const Camera& b : cameras)
      least =
          std::min(least, std::abs(line_of_sight(a, x_in_world).dot(line_of_sight(b, x_in_world))));
  return std::acos(least);
}

Vector3d rig_centre(const std::vector<Camera>& cameras) {
  Matrix3d normal = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const Camera& camera : cameras) {
    const Ray axis{camera.camera_from_world.inverse().t, camera.camera_from_world.R.row(2)};
    const Matrix3d across = Matrix3d::Identity() - axis.direction * axis.direction.transpose();
    normal += across;
    right += across * axis.origin;
  }
  return normal.completeOrthogonalDecomposition().solve(right);
}

}  // namespace trihedron
