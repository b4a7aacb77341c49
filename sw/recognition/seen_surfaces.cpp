// SPDX-License-Identifier: Apache-2.0
#include "recognition/seen_surfaces.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

#include "recognition/surface_attributes.hpp"

namespace trihedron {
namespace {

/// Fewer cells of a surface are not seen: 32 px^2.
constexpr int kLeastCells = 8;
/// An edge counts as found from this share of its length on.
constexpr double kFoundShare = 0.5;
/// Weak prior on a corner's motion in the plane, (px per mm)^2: directions that no edge measures
/// stay at rest.
constexpr double kPrior = 1e-3;

/// What one view measured of one model edge.
struct EdgeMeasurement {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset_px = 0;  // along the normal
  double found_px = 0, visible_px = 0;
  double whole_px = 0;  // hidden parts included

  bool found() const { return found_px >= kFoundShare * whole_px; }
};

struct Describer {
  const FieldView& view;
  const PlacedModel& placed;
  std::vector<EdgeMeasurement> edges;  // of the model

  Describer(const FieldView& field_view, const PlacedModel& placed_model)
      : view(field_view), placed(placed_model), edges(placed.model->edges.size()) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const ModelEdge& edge = placed.model->edges[e];
      edges[e].whole_px = (image(edge.v1) - image(edge.v0)).norm();
    }
  }

  Eigen::Vector3d in_world(int vertex) const {
    return placed.world_from_model * placed.model->mesh.vertices[vertex];
  }
  Eigen::Vector2d image(int vertex) const { return view.camera->project(in_world(vertex)); }

  void add(const PieceEvidence& piece) {
    EdgeMeasurement& edge = edges[piece.edge];
    const double found = piece.found * piece.length_px;
    edge.visible_px += piece.length_px;
    if (found <= 0) return;
    edge.normal = piece.normal;
    edge.offset_px =
        (edge.found_px * edge.offset_px + found * piece.offset_px) / (edge.found_px + found);
    edge.found_px += found;
  }

  int edge_between(int a, int b) const {
    for (int e : placed.model->vertex_edges[a]) {
      const ModelEdge& edge = placed.model->edges[e];
      if (edge.v0 == b || edge.v1 == b) return e;
    }
    return -1;  // not in a sound model
  }

  /// The corner between two measured edges of a surface with normal `normal` (world).
  Eigen::Vector3d corner(int vertex, const Eigen::Vector3d& normal, int before, int after) const {
    const Eigen::Vector3d x = in_world(vertex);
    const auto jacobian = view.camera->projection_jacobian(x);
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = normal.unitOrthogonal();
    plane.col(1) = normal.cross(plane.col(0));
    Eigen::Matrix2d A = kPrior * Eigen::Matrix2d::Identity();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (const int e : {before, after}) {
      if (e < 0 || edges[e].found_px <= 0) continue;
      const Eigen::Vector2d row = plane.transpose() * (jacobian.transpose() * edges[e].normal);
      A += row * row.transpose();
      b += edges[e].offset_px * row;
    }
    return x + plane * A.ldlt().solve(b);
  }

  SceneSurface describe(int surface, int view_index, double& found_share) const {
    const Surface& s = placed.model->surfaces[surface];
    SceneSurface out;
    out.view = view_index;
    std::vector<SpacePolygon> loops;
    double found = 0, visible = 0;
    for (const std::vector<int>& loop : s.loops) {
      loops.emplace_back();
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i) {
        const int before = edge_between(loop[(i + n - 1) % n], loop[i]);
        const int after = edge_between(loop[i], loop[(i + 1) % n]);
        loops.back().push_back(
            corner(loop[i], placed.world_from_model.R * s.normal, before, after));
        if (after < 0) continue;
        found += edges[after].found_px;
        visible += edges[after].visible_px;
        out.complete = out.complete && edges[after].found();
      }
    }
    const SurfaceAttributes attributes = surface_attributes(loops);
    out.vertices = loops.front();
    out.normal = attributes.normal;
    out.centroid = attributes.centroid;
    out.area = attributes.area;
    out.perimeter = attributes.perimeter;
    found_share = found / std::max(visible, 1e-9);
    return out;
  }
};

}  // namespace

void describe_surfaces(const std::vector<FieldView>& views, const std::vector<PlacedModel>& objects,
                       int index, const ObjectEvidence& evidence,
                       std::vector<SceneSurface>& surfaces, std::vector<SurfaceMatch>& matches) {
  for (int v = 0; v < static_cast<int>(views.size()); ++v) {
    Describer describer(views[v], objects[index]);
    for (const PieceEvidence& piece : evidence.pieces) {
      if (piece.view == v) describer.add(piece);
    }
    const auto seen = surface_visibility(*views[v].camera, objects, index);
    for (int s = 0; s < static_cast<int>(seen.size()); ++s) {
      if (seen[s].visible_cells < kLeastCells) continue;
      SurfaceMatch match;
      match.view = v;
      match.scene_surface = static_cast<int>(surfaces.size());
      match.model_surface = s;
      match.visible_share = static_cast<double>(seen[s].visible_cells) / seen[s].cells;
      surfaces.push_back(describer.describe(s, v, match.found_share));
      matches.push_back(match);
    }
  }
}

}  // namespace trihedron
