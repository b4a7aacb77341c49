// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "recognition/object_evidence.hpp"
#include "recognition/spread_map.hpp"

namespace trihedron {

/// A shape like a model, placed so that it has edges where contours lie beside the model's own.
struct SimilarShape {
  Model model;
  Transform world_from_model;
  std::string what;  ///< "9.8 % longer", "surface 3 lies +4.2 mm off the model's"
};

inline constexpr int kSimilarTried = 3;

/// The shapes near `placed` that promise most by its evidence, best first, at most kSimilarTried:
/// the model stretched along an axis, or with one surface moved, by as much as some displaced piece
/// of evidence asks for. `chance` is each view's map of all contours.
std::vector<SimilarShape> similar_shapes(const std::vector<FieldView>& views,
                                         const std::vector<SpreadMap>& chance,
                                         const PlacedModel& placed, const ObjectEvidence& evidence);

/// The model with its vertices moved: normals, offsets, centroids and lengths follow.
Model reshaped(const Model& model, const std::vector<Eigen::Vector3d>& vertices);

}  // namespace trihedron
