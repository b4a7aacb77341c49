// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/recognize.hpp"

namespace trihedron {

/// An object that is known to be in a scene.
struct TrueObject {
  int model_id = 0;
  Transform world_from_model;
};

/// How far a model at one pose is from the same model at another, the best of its symmetries
/// taken: the largest (BOP's MSSD) and the mean distance of its vertices, mm.
struct PoseError {
  double largest_mm = 0;
  double mean_mm = 0;
};
PoseError pose_error(const Model& model, const Transform& estimate, const Transform& truth);

/// One true object and what became of it.
struct ObjectScore {
  bool right = false;     ///< a result of the right model is nearer than 20 % of the diameter
  double recall = 0;      ///< share of BOP's thresholds (5, 10 .. 50 % of the diameter) it keeps
  double vertex_mm = -1;  ///< mean vertex error of a right one, -1: none
};

/// A scene's results held against the truth.
struct SceneScore {
  std::vector<ObjectScore> objects;  ///< per true object
  int wrong = 0;                     ///< results that match no true object
  int surfaces_described = 0;        ///< scene surfaces of which every vertex was found
  int surfaces_right = 0;  ///< of those, identified and where the true object has that surface
};

/// Each result, surest first, takes the nearest true object of its model that is still free.
SceneScore score_scene(const RecognitionResult& result, const std::vector<TrueObject>& truth,
                       const std::vector<Model>& library);

}  // namespace trihedron
