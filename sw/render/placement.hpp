// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/camera.hpp"
#include "recognition/model.hpp"
#include "render/random.hpp"
#include "render/rig.hpp"
#include "render/world.hpp"

namespace trihedron::render {

struct PlacementOptions {
  int objects = 1;
  bool stacked = false;        ///< one object rests on top of another
  bool leaning = false;        ///< one object leans against another
  bool repeat_models = false;  ///< one model may stand in the scene more than once
  double gap_mm = 3;           ///< least distance in plan of objects that stand on the table
  double image_margin_px = 4;  ///< every vertex lies this far inside every image
};

/// Places models of the library at random: stable poses on the table z = 0, any yaw, nothing
/// interpenetrates, everything inside every camera's image. Albedos are left at 1.
/// Throws Error when the library is empty or the field has no room for so many objects.
std::vector<PlacedObject> place_objects(const std::vector<Model>& library,
                                        const std::vector<Camera>& cameras, const Field& field,
                                        const PlacementOptions& options, Random& random);

}  // namespace trihedron::render
