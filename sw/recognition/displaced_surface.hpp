// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/object_evidence.hpp"

namespace trihedron {

/// A surface of the model that seems to lie elsewhere on the object in the scene.
struct DisplacedSurface {
  int surface = -1;
  double outwards_mm = 0;
  double log_odds = 0;  ///< natural logarithm, against the model as it is; above 0: likelier
};

/// The best place for one surface when its edges are not where the model says; log odds far below 0
/// when nothing speaks for another.
DisplacedSurface displaced_surface(const std::vector<FieldView>& views, const PlacedModel& placed,
                                   const ObjectEvidence& evidence, int surface);

}  // namespace trihedron
