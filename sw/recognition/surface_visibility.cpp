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
/// Beyond this a corner has no partner, not even one that is badly placed.
constexpr double kNoPartnerErrors = 3;

/// What the view of that role measures of a point.
Vector2d seen(const Vector3d& p, ViewRole role) {
  return {role == ViewRole::kFront ? p.y() : p.x(), role == ViewRole::kTop ? p.y() : p.z()};
}

/// The coordinate that the view shares with the top view.
int shared_axis(ViewRole role) { return role == ViewRole::kFront ? 1 : 0; }

std::vector<Polygon> seen(const CrossedSurface& surface, ViewRole role) {
  std::vector<Polygon> loops;
  for (const SpacePolygon& loop : surface.loops) {
    Polygon& polygon = loops.emplace_back();
    for (const Vector3d& v : loop) polygon.push_back(seen(v, role));
  }
  return loops;
}

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double length = d.squaredNorm();
  const double s = length > 0 ? std::clamp((p - a).dot(d) / length, 0.0, 1.0) : 0;
  return (p - a - s * d).norm();
}

bool on_boundary(const std::vector<Polygon>& loops, const Vector2d& p, double error_mm) {
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (distance_to_segment(p, loop[i], loop[(i + 1) % loop.size()]) <= error_mm) return true;
    }
  }
  return false;
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

bool at_corner(const std::vector<Polygon>& loops, const Vector2d& p, double reach_mm) {
  for (const Polygon& loop : loops) {
    for (const Vector2d& v : loop) {
      if ((v - p).cwiseAbs().maxCoeff() <= reach_mm) return true;
    }
  }
  return false;
}

/// Those of `points` that agree with none of `others` in the given coordinate.
SpacePolygon without_partner(const SpacePolygon& points, const SpacePolygon& others, int axis,
                             double error_mm) {
  SpacePolygon left;
  for (const Vector3d& p : points) {
    if (std::none_of(others.begin(), others.end(), [&](const Vector3d& o) {
          return std::abs(o[axis] - p[axis]) <= kNoPartnerErrors * error_mm;
        })) {
      left.push_back(p);
    }
  }
  return left;
}

bool in_front(const Vector3d& p, const CrossedSurface& surface, double error_mm) {
  const SurfaceAttributes& a = surface.attributes;
  return (p - a.centroid).dot(a.normal) > kFrontErrors * error_mm;
}

/// A known corner in front of a side or front surface.
bool hides(const Vector3d& corner, const CrossedSurface& surface, double error_mm) {
  if (!in_front(corner, surface, error_mm)) return false;
  const std::vector<Polygon> loops = seen(surface, surface.role);
  const Vector2d p = seen(corner, surface.role);
  return !at_corner(loops, p, kFrontErrors * error_mm) &&
         (on_boundary(loops, p, error_mm) || inside(loops, p));
}

/// A top corner of unknown height in front of a side or front surface, at whatever height of it.
bool may_hide(Vector3d corner, const CrossedSurface& surface, double error_mm) {
  const int axis = shared_axis(surface.role);
  Vector3d low = surface.loops[0][0], high = low;
  for (const Vector3d& v : surface.loops[0]) low = low.cwiseMin(v), high = high.cwiseMax(v);
  if (corner[axis] <= low[axis] || corner[axis] >= high[axis]) return false;
  corner.z() = surface.attributes.normal.z() > 0 ? low.z() : high.z();
  return in_front(corner, surface, error_mm);
}

/// A side or front corner that interrupts an edge of a top surface.
bool interrupts(const Vector3d& corner, ViewRole role, const CrossedSurface& surface,
                double error_mm) {
  return on_boundary(seen(surface, role), seen(corner, role), error_mm);
}

}  // namespace

std::vector<bool> contradicted_surfaces(const std::vector<CrossedSurface>& surfaces,
                                        const MeasuredCorners& corners, double error_mm) {
  std::array<SpacePolygon, 3> alone;   // by role; [0] unused
  std::array<SpacePolygon, 3> unseen;  // top corners without a partner in that view
  for (const std::size_t v : {1, 2}) {
    const int axis = shared_axis(static_cast<ViewRole>(v));
    alone[v] = without_partner(corners[v], corners[0], axis, error_mm);
    unseen[v] = without_partner(corners[0], corners[v], axis, error_mm);
  }
  std::vector<bool> contradicted;
  SpacePolygon top_corners;
  for (const CrossedSurface& s : surfaces) {
    const auto any = [](const SpacePolygon& points, const auto& test) {
      return std::any_of(points.begin(), points.end(), test);
    };
    bool wrong = false;
    if (s.role == ViewRole::kTop) {
      for (const ViewRole role : {ViewRole::kSide, ViewRole::kFront}) {
        wrong = wrong || any(alone[static_cast<std::size_t>(role)],
                             [&](const Vector3d& p) { return interrupts(p, role, s, error_mm); });
      }
      for (const SpacePolygon& loop : s.loops) {
        if (!wrong) top_corners.insert(top_corners.end(), loop.begin(), loop.end());
      }
    } else {
      wrong = any(top_corners, [&](const Vector3d& p) { return hides(p, s, error_mm); }) ||
              any(unseen[static_cast<std::size_t>(s.role)],
                  [&](const Vector3d& p) { return may_hide(p, s, error_mm); });
    }
    contradicted.push_back(wrong);
  }
  return contradicted;
}

}  // namespace trihedron
