// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "recognition/refinement.hpp"

namespace trihedron {
namespace {

/// Lines nearer than this to a profile's middle reach into its bell, px.
constexpr double kClearancePx = 5.0;

double distance_to_piece(const Eigen::Vector2d& x, const VisibleEdge& piece) {
  const Eigen::Vector2d along = piece.x1 - piece.x0;
  const double t = along.dot(x - piece.x0) / std::max(along.squaredNorm(), 1e-12);
  return (x - piece.x0 - std::clamp(t, 0.0, 1.0) * along).norm();
}

bool is_crowded(const Eigen::Vector2d& x, std::size_t own, const std::vector<VisibleEdge>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i == own || edges[i].edge == edges[own].edge) continue;
    const Eigen::Vector2d& a = edges[i].x0;
    const Eigen::Vector2d& b = edges[i].x1;
    if (x.x() < std::min(a.x(), b.x()) - kClearancePx ||
        x.x() > std::max(a.x(), b.x()) + kClearancePx ||
        x.y() < std::min(a.y(), b.y()) - kClearancePx ||
        x.y() > std::max(a.y(), b.y()) + kClearancePx) {
      continue;
    }
    if (distance_to_piece(x, edges[i]) < kClearancePx) return true;
  }
  return false;
}

}  // namespace

std::vector<EdgePoint> edge_points(const FieldView& view, int view_index,
                                   const std::vector<VisibleEdge>& edges, double step_px,
                                   double end_px, double outside_px) {
  std::vector<EdgePoint> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const VisibleEdge& edge = edges[i];
    const double usable = edge.length_px - 2 * end_px;
    if (usable <= 0) continue;
    const int count = 1 + static_cast<int>(usable / step_px);
    for (int k = 0; k < count; ++k) {
      const double from_start = end_px + (k + 0.5) * usable / count;
      const double s = from_start / edge.length_px;
      EdgePoint p;
      p.view = view_index;
      p.piece = static_cast<int>(i);
      p.x_in_world = edge.x0_in_world + s * (edge.x1_in_world - edge.x0_in_world);
      p.x = view.camera->project(p.x_in_world);
      p.normal = edge.normal;
      if (!view.field->inside(p.x, ContourField::kProfilePx - outside_px)) continue;
      p.crowded = is_crowded(p.x, i, edges);
      out.push_back(p);
    }
  }
  return out;
}

}  // namespace trihedron
