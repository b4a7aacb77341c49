// SPDX-License-Identifier: Apache-2.0
#include "recognition/surface_visibility.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Polygon = std::vector<Vector2d>;

/// Corners are known to one Error in each of two coordinates, planes to as much.
constexpr double kFrontErrors = 2;

/// What the view measures of a point.
Vector2d seen(const Vector3d& p, ViewRole role) {
  return {role == ViewRole::kFront ? p.y() : p.x(), role == ViewRole::kTop ? p.y() : p.z()};
}

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double length = d.squaredNorm();
  const double s = length > 0 ? std::clamp((p - a).dot(d) / length, 0.0, 1.0) : 0;
  return (p - a - s * d).norm();
}

/// Even-odd over all loops.
bool inside(const std::vector<Polygon>& loops, const Vector2d& p) {
  bool odd = false;
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      odd ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    }
  }
  return odd;
}

}  // namespace

bool contradicts(const Vector3d& corner, const CrossedSurface& surface, double error_mm) {
  const SurfaceAttributes& a = surface.attributes;
  if ((corner - a.centroid).dot(a.normal) <= kFrontErrors * error_mm) return false;
  const Vector2d p = seen(corner, surface.role);
  std::vector<Polygon> loops;
  bool on_boundary = false;
  for (const SpacePolygon& loop : surface.loops) {
    Polygon& polygon = loops.emplace_back();
    for (const Vector3d& v : loop) polygon.push_back(seen(v, surface.role));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if ((p - polygon[i]).cwiseAbs().maxCoeff() <= kFrontErrors * error_mm) return false;
      const Vector2d& next = polygon[(i + 1) % polygon.size()];
      on_boundary = on_boundary || distance_to_segment(p, polygon[i], next) <= error_mm;
    }
  }
  return on_boundary || inside(loops, p);
}

}  // namespace trihedron
