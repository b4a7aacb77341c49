// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "render/contact.hpp"
#include "render/random.hpp"
#include "render/rig.hpp"
#include "render/stable_pose.hpp"

namespace trihedron::render {

/// A random place in the field, any yaw, standing on the table z = 0 in the pose.
std::optional<Transform> rest_on_table(const Model& model, const StablePose& pose,
                                       const Field& field, Random& random);

/// A random place on the highest horizontal faces of `base` from which the model does not fall:
/// its centre of mass is over the area of contact. Nothing when the draw finds none.
std::optional<Transform> rest_on_top(const Model& model, const StablePose& pose, const Body& base,
                                     Random& random);

/// The model tilted over an edge of its support face, that edge on the table, and pushed against
/// `other` until they touch, so that `other` keeps it from falling back. Nothing when the draw
/// finds none.
std::optional<Transform> lean_against(const Model& model, const StablePose& pose, const Body& other,
                                      Random& random);

}  // namespace trihedron::render
