// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper_positioning.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Relative to the model's edge (eq. 19).
constexpr double kEdgeTolerance = 0.20;
/// The paper's claim for its positions: "an average error less than 10 % of the smallest
/// dimension" (its section 5.1).
constexpr double kPositionTolerance = 0.10;
constexpr double kPi = 3.14159265358979323846;

/// Turns unit vector `from` onto unit vector `to` about their common perpendicular (eq. 23).
Matrix3d turn_onto(const Vector3d& from, const Vector3d& to) {
  const Vector3d axis = from.cross(to);
  if (axis.norm() > 1e-9) {
    const double angle = std::atan2(axis.norm(), from.dot(to));
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  }
  if (from.dot(to) > 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(kPi, from.unitOrthogonal()).toRotationMatrix();
}

/// Scene vertices and the model surface they belong to, model frame.
struct VertexMatch {
  std::vector<Vector3d> scene, model;
};

std::vector<VertexMatch> vertex_matches(const PaperScene& scene, const Model& model,
                                        const PaperSequence& matches) {
  std::vector<VertexMatch> out;
  for (const PaperMatch& match : matches) {
    VertexMatch& v = out.emplace_back();
    for (const SpacePolygon& loop : scene.loops[static_cast<std::size_t>(match.scene_surface)]) {
      v.scene.insert(v.scene.end(), loop.begin(), loop.end());
    }
    for (const SpacePolygon& loop : surface_loops(model, match.model_surface)) {
      v.model.insert(v.model.end(), loop.begin(), loop.end());
    }
  }
  return out;
}

double mean_distance(const std::vector<VertexMatch>& matches, const Transform& world_from_model) {
  double sum = 0;
  int count = 0;
  for (const VertexMatch& match : matches) {
    for (const Vector3d& scene : match.scene) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector3d& model : match.model) {
        nearest = std::min(nearest, (world_from_model * model - scene).norm());
      }
      sum += nearest;
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

Transform position_surface(const SurfaceAttributes& scene, int scene_edge,
                           const SurfaceAttributes& model, int model_edge) {
  const Matrix3d first = turn_onto(model.normal, scene.normal);
  const Vector3d pmm =
      first * (model.edge_middles[static_cast<std::size_t>(model_edge)] - model.centroid);
  const Vector3d pmc = scene.edge_middles[static_cast<std::size_t>(scene_edge)] - scene.centroid;
  const double angle = std::atan2(pmm.cross(pmc).dot(scene.normal), pmm.dot(pmc));
  Transform world_from_model;
  world_from_model.R = Eigen::AngleAxisd(angle, scene.normal).toRotationMatrix() * first;
  world_from_model.t = scene.centroid - world_from_model.R * model.centroid;
  return world_from_model;
}

std::optional<PaperPosition> position_model(const PaperScene& scene, const Model& model,
                                            const std::vector<SurfaceAttributes>& model_surfaces,
                                            const PaperSequence& matches) {
  const std::vector<VertexMatch> vertices = vertex_matches(scene, model, matches);
  const double max_error = kPositionTolerance * smallest_dimension_mm(model);
  std::optional<PaperPosition> best;
  for (const PaperMatch& match : matches) {
    const SurfaceAttributes& s = scene.surfaces[static_cast<std::size_t>(match.scene_surface)];
    const SurfaceAttributes& m = model_surfaces[static_cast<std::size_t>(match.model_surface)];
    for (int e = 0; e < s.edges(); ++e) {
      for (int f = 0; f < m.edges(); ++f) {
        const double length = m.edge_lengths[static_cast<std::size_t>(f)];
        if (std::abs(s.edge_lengths[static_cast<std::size_t>(e)] - length) >
            kEdgeTolerance * length) {
          continue;
        }
        PaperPosition position{position_surface(s, e, m, f), 0, {}};
        position.error_mm = mean_distance(vertices, position.world_from_model);
        if (position.error_mm > max_error) continue;
        position.support =
            corner_support(scene.corners, model, position.world_from_model, scene.tolerance_mm());
        if (!best || position.better_than(*best)) best = position;
      }
    }
  }
  return best;
}

double smallest_dimension_mm(const Model& model) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Surface& surface : model.surfaces) {
    double low = 0, high = 0;
    for (const Vector3d& v : model.mesh.vertices) {
      const double height = surface.normal.dot(v) - surface.offset;
      low = std::min(low, height);
      high = std::max(high, height);
    }
    smallest = std::min(smallest, high - low);
  }
  return smallest;
}

}  // namespace trihedron
