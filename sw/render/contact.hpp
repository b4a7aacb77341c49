// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/world.hpp"

namespace trihedron::render {

/// A placed body: its mesh in the world frame, mm.
struct Body {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  Eigen::Vector3d mass;  ///< centre of mass
};

Body make_body(const PlacedObject& object);

/// True when the solids share a point: a surface of one crosses one of the other, or one holds the
/// other. Surfaces that lie in one plane and only touch may count as either.
bool interpenetrate(const Body& a, const Body& b);

/// A lower bound, exact face to face, of the distance of the bodies' convex outlines seen from
/// above, mm; negative when these overlap.
double gap_in_plan(const Body& a, const Body& b);

/// The outline, convex and counter-clockwise, of the area in which `upper` touches `lower` from
/// above, both resting on horizontal faces at height z (mm): where faces of `lower` that look up
/// and faces of `upper` that look down overlap. Empty when they do not.
std::vector<Eigen::Vector2d> contact_outline(const Body& lower, const Body& upper, double z);

}  // namespace trihedron::render
