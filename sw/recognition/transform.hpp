// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace trihedron {

/// A rigid motion, named b_from_a: x_in_b = b_from_a * x_in_a. R is a proper rotation
/// (det = +1), t is in mm.
struct Transform {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& x) const { return R * x + t; }
  Transform operator*(const Transform& b) const { return {R * b.R, R * b.t + t}; }
  Transform inverse() const { return {R.transpose(), -(R.transpose() * t)}; }
};

}  // namespace trihedron
