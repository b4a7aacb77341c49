// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "golden/features.hpp"
#include "recognition/camera.hpp"
#include "recognition/model.hpp"

namespace trihedron {

enum class Method { kPaper, kFull };

struct RecognitionOptions {
  Method method = Method::kFull;
};

/// What recognition gets: per view its calibration and what left the hardware's ports.
struct View {
  Camera camera;
  ViewFeatures features;
};

/// A model surface that was seen.
struct SurfaceMatch {
  int view = 0;              ///< index of the view
  int scene_surface = 0;     ///< index into RecognitionResult::surfaces, -1: none described
  int model_surface = 0;     ///< index into Model::surfaces
  double visible_share = 1;  ///< of its area in this view, that other objects leave
  double found_share = 1;    ///< of its visible outline, that was found as contour
};

/// A surface in 3D: method paper reconstructs it from the crossed views, method full measures it
/// in one view, in the plane that the object's pose gives it.
struct SceneSurface {
  int view = 0;                           ///< the view whose region it comes from
  std::vector<Eigen::Vector3d> vertices;  ///< world, mm, counter-clockwise seen from the camera
  Eigen::Vector3d normal, centroid;       ///< world, towards the camera
  double area = 0, perimeter = 0;         ///< mm^2, mm
  bool complete = true;                   ///< every vertex found its partner; full: every edge
                                          ///< was found
};

struct RecognizedObject {
  int model_id = 0;
  Transform world_from_model;
  Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Zero();  ///< of (rotation vector rad, translation mm), world
  double score = 0;                         ///< 0..1, larger is surer
  double reprojection_rms_px = 0;
  int runner_up_model_id = -1;  ///< next best model here, -1: none
  double runner_up_score = 0;
  std::vector<SurfaceMatch> surfaces;
};

/// A hypothesis that was not accepted, and why.
struct Rejection {
  int model_id = 0;
  Transform world_from_model;
  double score = 0;
  std::string reason;
};

struct StageStatistics {
  std::string stage;  ///< "regions", "surfaces", "hypotheses", "poses"
  int count = 0;      ///< what the stage produced
  double seconds = 0;
};

struct RecognitionResult {
  std::vector<RecognizedObject> objects;  ///< by decreasing score
  std::vector<Rejection> rejections;
  std::vector<SceneSurface> surfaces;
  std::vector<StageStatistics> stages;
};

/// Finds the library's models in the views. Deterministic: same input, same output. For many scenes
/// use a Recognizer (recognizer.hpp), which prepares the library once.
/// Throws Error when there are fewer than two views or a view's features and camera differ in
/// size.
RecognitionResult recognize(const std::vector<View>& views, const std::vector<Model>& library,
                            const RecognitionOptions& options = {});

}  // namespace trihedron
