// SPDX-License-Identifier: Apache-2.0
#include "recognition/camera.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Where the lens moves the ideal point `p` (normalised image plane): the Brown-Conrady model in
/// OpenCV's order k1 k2 p1 p2 k3.
Vector2d distorted(const std::array<double, 5>& d, const Vector2d& p) {
  const double x = p.x(), y = p.y(), r2 = x * x + y * y;
  const double radial = 1 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
  return {x * radial + 2 * d[2] * x * y + d[3] * (r2 + 2 * x * x),
          y * radial + d[2] * (r2 + 2 * y * y) + 2 * d[3] * x * y};
}

/// Its derivative by the ideal point.
Matrix2d distortion_jacobian(const std::array<double, 5>& d, const Vector2d& p) {
  const double k1 = d[0], k2 = d[1], p1 = d[2], p2 = d[3], k3 = d[4];
  const double x = p.x(), y = p.y(), r2 = x * x + y * y;
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3));  // d radial / dx = slope * x
  const double mixed = slope * x * y + 2 * p1 * x + 2 * p2 * y;
  Matrix2d out;
  out << radial + slope * x * x + 2 * p1 * y + 6 * p2 * x, mixed,  //
      mixed, radial + slope * y * y + 6 * p1 * y + 2 * p2 * x;
  return out;
}

bool has_distortion(const Camera& camera) {
  return camera.projection == Camera::Projection::kPinhole &&
         std::any_of(camera.distortion.begin(), camera.distortion.end(),
                     [](double k) { return k != 0; });
}

/// Position in px of a point of the normalised image plane.
Vector2d to_pixel(const Eigen::Matrix3d& K, const Vector2d& p) {
  return {K(0, 0) * p.x() + K(0, 1) * p.y() + K(0, 2), K(1, 1) * p.y() + K(1, 2)};
}

Vector2d from_pixel(const Eigen::Matrix3d& K, const Vector2d& pixel) {
  const double y = (pixel.y() - K(1, 2)) / K(1, 1);
  return {(pixel.x() - K(0, 2) - K(0, 1) * y) / K(0, 0), y};
}

/// The ideal point whose distorted image is `target`, by Newton's method.
Vector2d invert_distortion(const std::array<double, 5>& d, const Vector2d& target) {
  constexpr int kMaxSteps = 20;         // quadratic: 5 do for any usable lens
  constexpr double kConverged = 1e-12;  // far below a millionth of a pixel
  Vector2d p = target;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Vector2d step = distortion_jacobian(d, p).inverse() * (target - distorted(d, p));
    if (!step.allFinite()) break;
    p += step;
    if (step.norm() < kConverged) break;
  }
  return p;
}

}  // namespace

Vector2d Camera::project_camera(const Vector3d& x_in_camera) const {
  if (projection == Projection::kOrthographic)
    return px_per_mm * x_in_camera.head<2>() + K.topRightCorner<2, 1>();
  const Vector2d ideal = x_in_camera.head<2>() / x_in_camera.z();
  return to_pixel(K, distorted(distortion, ideal));
}

Vector2d Camera::project(const Vector3d& x_in_world) const {
  return project_camera(camera_from_world * x_in_world);
}

Vector2d Camera::undistort(const Vector2d& pixel) const {
  if (!has_distortion(*this)) return pixel;
  return to_pixel(K, invert_distortion(distortion, from_pixel(K, pixel)));
}

Ray Camera::ray(const Vector2d& pixel) const {
  const Transform world_from_camera = camera_from_world.inverse();
  if (projection == Projection::kOrthographic) {
    const Vector2d p = (pixel - K.topRightCorner<2, 1>()) / px_per_mm;
    return {world_from_camera * Vector3d(p.x(), p.y(), 0), world_from_camera.R.col(2)};
  }
  const Vector2d p = from_pixel(K, undistort(pixel));
  return {world_from_camera.t, world_from_camera.R * Vector3d(p.x(), p.y(), 1).normalized()};
}

Eigen::Matrix<double, 2, 3> Camera::projection_jacobian(const Vector3d& x_in_world) const {
  Eigen::Matrix<double, 2, 3> in_camera = Eigen::Matrix<double, 2, 3>::Zero();
  if (projection == Projection::kOrthographic) {
    in_camera.leftCols<2>().diagonal().setConstant(px_per_mm);
  } else {
    const Vector3d x = camera_from_world * x_in_world;
    const Vector2d p = x.head<2>() / x.z();
    in_camera << 1 / x.z(), 0, -p.x() / x.z(), 0, 1 / x.z(), -p.y() / x.z();
    if (has_distortion(*this))
      in_camera = distortion_jacobian(distortion, p).lazyProduct(in_camera).eval();
    in_camera.row(0) = K(0, 0) * in_camera.row(0) + K(0, 1) * in_camera.row(1);
    in_camera.row(1) *= K(1, 1);
  }
  return in_camera.lazyProduct(camera_from_world.R);
}

double Camera::px_per_mm_at(const Vector3d& x_in_world) const {
  if (projection == Projection::kOrthographic) return px_per_mm;
  return std::sqrt(K(0, 0) * K(1, 1)) / (camera_from_world * x_in_world).z();
}

}  // namespace trihedron
