// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "recognition/refinement.hpp"

namespace trihedron {
namespace {

/// Lines nearer than this to a profile's middle reach into its bell, px.
constexpr double kClearancePx = 5.0;

/// A piece of another edge that runs near.
struct Line {
  Eigen::Vector2d from, along;  // unit
  double length;

  bool clears(const Eigen::Vector2d& x) const {
    const Eigen::Vector2d to = x - from;
    const double t = std::clamp(along.dot(to), 0.0, length);
    return (to - t * along).squaredNorm() >= kClearancePx * kClearancePx;
  }
};

/// The pieces of other edges that may come near to `edges[own]`.
void lines_near(const std::vector<VisibleEdge>& edges, std::size_t own, std::vector<Line>& out) {
  out.clear();
  const VisibleEdge& e = edges[own];
  const auto apart = [](double a0, double a1, double b0, double b1) {
    return std::min(a0, a1) - kClearancePx > std::max(b0, b1) ||
           std::min(b0, b1) - kClearancePx > std::max(a0, a1);
  };
  for (const VisibleEdge& other : edges) {
    if (other.edge == e.edge || apart(e.x0.x(), e.x1.x(), other.x0.x(), other.x1.x()) ||
        apart(e.x0.y(), e.x1.y(), other.x0.y(), other.x1.y())) {
      continue;
    }
    const Eigen::Vector2d along = other.x1 - other.x0;
    out.push_back({other.x0, along / std::max(other.length_px, 1e-6), other.length_px});
  }
}

}  // namespace

std::vector<EdgePoint> edge_points(const FieldView& view, int view_index,
                                   const std::vector<VisibleEdge>& edges, double step_px,
                                   double end_px, double outside_px) {
  std::vector<EdgePoint> out;
  out.reserve(static_cast<std::size_t>(std::accumulate(
      edges.begin(), edges.end(), 0.0,
      [&](double sum, const VisibleEdge& edge) { return sum + 1 + edge.length_px / step_px; })));
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
      out.push_back(p);
    }
  }
  return out;
}

void mark_crowded(const std::vector<VisibleEdge>& edges, std::vector<EdgePoint>& points) {
  std::vector<Line> near;
  int piece = -1;
  for (EdgePoint& p : points) {
    if (p.piece != piece) lines_near(edges, static_cast<std::size_t>(p.piece), near);
    piece = p.piece;
    p.crowded =
        std::any_of(near.begin(), near.end(), [&](const Line& line) { return !line.clears(p.x); });
  }
}

}  // namespace trihedron
