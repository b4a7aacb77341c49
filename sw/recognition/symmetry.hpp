// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// Two shapes are the same when every vertex of one lies this part of the diameter from one of
/// the other: a tenth of a pixel for an object 100 px wide, which no view can tell apart.
constexpr double kSameShape = 1e-3;

/// All proper motions b_from_a that map model a onto model b, vertices onto vertices and
/// surfaces onto surfaces; none when the shapes differ (mirror images differ). At most 2 * edges
/// motions, in the order of b's edges.
std::vector<Transform> congruences(const Model& a, const Model& b);

/// Whether the motion leaves every vertex of the model in its place, within kSameShape.
bool is_identity(const Transform& motion, const Model& model);

/// The rigid motion b_from_a that maps points a onto points b with least squared error
/// (Kabsch). Equal numbers of points, at least three, not all on a line.
Transform best_motion(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b);

}  // namespace trihedron
