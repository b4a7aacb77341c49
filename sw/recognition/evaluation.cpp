// SPDX-License-Identifier: Apache-2.0
#include "recognition/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace trihedron {
namespace {

using Eigen::Vector3d;

constexpr double kRight = 0.2;  // of the diameter, on the largest vertex error

const Model* find_model(const std::vector<Model>& library, int id) {
  for (const Model& model : library)
    if (model.id == id) return &model;
  return nullptr;
}

PoseError error_at(const Model& model, const Transform& a, const Transform& b) {
  PoseError error;
  for (const Vector3d& x : model.mesh.vertices) {
    const double distance = (a * x - b * x).norm();
    error.largest_mm = std::max(error.largest_mm, distance);
    error.mean_mm += distance / static_cast<double>(model.mesh.vertices.size());
  }
  return error;
}

double recall_of(double largest_mm, double diameter) {
  constexpr int kThresholds = 10;  // 5, 10 .. 50 %
  int kept = 0;
  for (int i = 1; i <= kThresholds; ++i) kept += largest_mm < 0.05 * i * diameter ? 1 : 0;
  return static_cast<double>(kept) / kThresholds;
}

/// The truth's pose of the same model, turned by the symmetry that lies nearest to `estimate`.
Transform nearest_truth(const Model& model, const Transform& estimate, const Transform& truth) {
  Transform best = truth;
  double error = error_at(model, estimate, truth).largest_mm;
  for (const Transform& symmetry : model.symmetries) {
    const double e = error_at(model, estimate, truth * symmetry).largest_mm;
    if (e >= error) continue;
    error = e;
    best = truth * symmetry;
  }
  return best;
}

/// Whether a reconstructed surface lies where the true object has the surface it was taken for.
bool surface_is_right(const SceneSurface& scene, const Model& model, int surface,
                      const Transform& world_from_model) {
  constexpr double kCosine = 0.966;               // 15 degrees
  constexpr double kPlane = 0.05, kCentre = 0.2;  // of the diameter
  const Surface& s = model.surfaces[static_cast<std::size_t>(surface)];
  const Vector3d normal = world_from_model.R * s.normal;
  const Vector3d offset = scene.centroid - world_from_model * s.centroid;
  return normal.dot(scene.normal) > kCosine &&
         std::abs(normal.dot(offset)) < kPlane * model.diameter &&
         offset.norm() < kCentre * model.diameter;
}

int count_right_surfaces(const RecognitionResult& result, const RecognizedObject& object,
                         const Model& model, const Transform& truth) {
  const Transform world_from_model = nearest_truth(model, object.world_from_model, truth);
  std::vector<int> counted;
  for (const SurfaceMatch& match : object.surfaces) {
    if (match.scene_surface < 0) continue;
    const SceneSurface& scene = result.surfaces[static_cast<std::size_t>(match.scene_surface)];
    if (scene.complete && surface_is_right(scene, model, match.model_surface, world_from_model))
      counted.push_back(match.scene_surface);
  }
  std::sort(counted.begin(), counted.end());
  return static_cast<int>(std::unique(counted.begin(), counted.end()) - counted.begin());
}

/// The free true object of the result's model that is nearest, -1: none.
int nearest_object(const RecognizedObject& object, const Model& model,
                   const std::vector<TrueObject>& truth, const std::vector<char>& taken,
                   PoseError& error) {
  int best = -1;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (taken[i] || truth[i].model_id != object.model_id) continue;
    const PoseError e = pose_error(model, object.world_from_model, truth[i].world_from_model);
    if (best >= 0 && e.largest_mm >= error.largest_mm) continue;
    error = e;
    best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

PoseError pose_error(const Model& model, const Transform& estimate, const Transform& truth) {
  return error_at(model, estimate, nearest_truth(model, estimate, truth));
}

SceneScore score_scene(const RecognitionResult& result, const std::vector<TrueObject>& truth,
                       const std::vector<Model>& library) {
  SceneScore score;
  score.objects.resize(truth.size());
  score.surfaces_described =
      static_cast<int>(std::count_if(result.surfaces.begin(), result.surfaces.end(),
                                     [](const SceneSurface& s) { return s.complete; }));
  std::vector<std::size_t> order(result.objects.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result.objects[a].score > result.objects[b].score;
  });
  std::vector<char> taken(truth.size(), 0);
  for (std::size_t i : order) {
    const RecognizedObject& object = result.objects[i];
    const Model* const model = find_model(library, object.model_id);
    PoseError error;
    const int at = model == nullptr ? -1 : nearest_object(object, *model, truth, taken, error);
    if (at < 0 || error.largest_mm >= kRight * model->diameter) {
      ++score.wrong;
      continue;
    }
    taken[at] = 1;
    score.objects[at] = {true, recall_of(error.largest_mm, model->diameter), error.mean_mm};
    score.surfaces_right +=
        count_right_surfaces(result, object, *model, truth[at].world_from_model);
  }
  return score;
}

}  // namespace trihedron
