// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recognition/transform.hpp"

namespace trihedron {

/// A model that might stand in the scene, and where.
struct PoseHypothesis {
  int model = 0;               ///< index into the library (not Model::id)
  Transform world_from_model;  ///< mm
  double support = 0;          ///< larger is likelier; comparable within one scene only
};

}  // namespace trihedron
