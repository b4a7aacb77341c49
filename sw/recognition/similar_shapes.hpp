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
  std::string what;  ///< "one 9 % longer", "surface 3 of the object lies +4.2 mm off the model's"
};

/// Shapes to hold a claim against.
struct SimilarShapes {
  std::vector<SimilarShape> shapes;
  /// log of the number of shapes they were chosen from: so much more must one of them explain.
  double log_choices = 0;
};

inline constexpr int kSimilarTried = 3;
/// Shapes this much longer or shorter in one dimension must be told apart at least.
inline constexpr double kSimilarStretch = 0.1;

/// Shapes that contours beside the edges of `placed` speak for: the model stretched along an axis,
/// or with one surface moved, by as much as some displaced piece of evidence asks for, where the
/// model stands; at most kSimilarTried, most promising first. `chance` is each view's map of all
/// contours.
SimilarShapes similar_shapes(const std::vector<FieldView>& views,
                             const std::vector<SpreadMap>& chance, const PlacedModel& placed,
                             const ObjectEvidence& evidence);

/// The model stretched by kSimilarStretch, either way, along each axis of its frame, whatever the
/// evidence asks for; per axis and way kStretchPlaces shapes, with either end and with the middle
/// at rest: where exactly such a shape stands has to be found.
SimilarShapes stretched_shapes(const PlacedModel& placed);
inline constexpr int kStretchPlaces = 3;

/// The model with its vertices moved: normals, offsets, centroids and lengths follow.
Model reshaped(const Model& model, const std::vector<Eigen::Vector3d>& vertices);

}  // namespace trihedron
