// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron::render {

/// A way in which a body rests on a horizontal plane.
struct StablePose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< world from model: the support face is below
  double lowest = 0;                                ///< z of the support face after R, mm
  double steadiness = 0;  ///< rad that the body can be tilted before it falls over
};

/// Centre of mass of a closed mesh of uniform density, mm, model frame.
Eigen::Vector3d centre_of_mass(const Mesh& mesh);

/// The faces of the convex hull over which the centre of mass stands by at least `steadiness`
/// (rad), as poses. Never empty for a closed body and a small enough angle.
std::vector<StablePose> stable_poses(const Mesh& mesh, double steadiness);

/// The convex hull of points in the plane, counter-clockwise, without points on its edges.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Distance from `p` to the border of a counter-clockwise convex polygon, mm; negative outside.
double depth_inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p);

}  // namespace trihedron::render
