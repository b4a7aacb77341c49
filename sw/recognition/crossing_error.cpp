// SPDX-License-Identifier: Apache-2.0
#include "recognition/crossing_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// Largest error of a fitted corner, px: a contour is one pixel wide.
constexpr double kCornerErrorPx = 0.5;

/// Distance between the segments a0 a1 and b0 b1. Its minimum is at an end of one of them, or
/// at the foot points of the common perpendicular.
double segment_distance(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0,
                        const Vector3d& b1) {
  const auto to_segment = [](const Vector3d& p, const Vector3d& q0, const Vector3d& q1) {
    const Vector3d d = q1 - q0;
    const double s = std::clamp((p - q0).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (p - q0 - s * d).norm();
  };
  double distance = std::min({to_segment(a0, b0, b1), to_segment(a1, b0, b1),
                              to_segment(b0, a0, a1), to_segment(b1, a0, a1)});
  const Vector3d u = a1 - a0, v = b1 - b0, w = b0 - a0;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double det = uu * vv - uv * uv;
  if (det > 1e-12 * uu * vv) {
    const double s = (u.dot(w) * vv - uv * v.dot(w)) / det;
    const double t = (uv * u.dot(w) - uu * v.dot(w)) / det;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
      distance = std::min(distance, (w + t * v - s * u).norm());
  }
  return distance;
}

}  // namespace

double smallest_edge_gap_mm(const Model& model) {
  double gap = std::numeric_limits<double>::infinity();
  const auto vertex = [&](int v) { return model.mesh.vertices[static_cast<std::size_t>(v)]; };
  for (std::size_t i = 0; i < model.edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ModelEdge &a = model.edges[i], &b = model.edges[j];
      if (a.v0 == b.v0 || a.v0 == b.v1 || a.v1 == b.v0 || a.v1 == b.v1) continue;
      gap = std::min(gap, segment_distance(vertex(a.v0), vertex(a.v1), vertex(b.v0), vertex(b.v1)));
    }
  }
  return gap;
}

double crossing_error_mm(const std::array<PlanarView, 3>& views,
                         const std::vector<Model>& library) {
  double mm_per_px = 0;
  for (const PlanarView& view : views) mm_per_px = std::max(mm_per_px, view.mm_per_px);
  double error = 2 * kCornerErrorPx * mm_per_px;
  for (const Model& model : library) error = std::min(error, 0.5 * smallest_edge_gap_mm(model));
  return error;
}

}  // namespace trihedron
