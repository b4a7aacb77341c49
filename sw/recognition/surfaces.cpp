// SPDX-License-Identifier: Apache-2.0
#include "recognition/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace trihedron {
namespace {

using Eigen::Vector3d;

constexpr int kX = 0, kY = 1, kZ = 2;
/// Relative difference up to which two surfaces are the same one (eqs. 9-13).
constexpr double kDuplicateTolerance = 0.20;
/// Largest error of a fitted corner, px: a contour is one pixel wide.
constexpr double kCornerErrorPx = 0.5;

/// A true corner is within Error of its place in each coordinate, so within sqrt(3) Error of its
/// plane; the plane itself is known better than that.
constexpr double kPlanarityErrors = 2;

/// What a view measures of a region's loops: two of three coordinates.
std::vector<SpacePolygon> measure(const PlanarView& view, const Region& region) {
  std::vector<SpacePolygon> loops(1);
  for (const Eigen::Vector2d& px : region.outer) loops[0].push_back(view.measure(px));
  for (const ImagePolygon& hole : region.holes) {
    SpacePolygon& loop = loops.emplace_back();
    for (const Eigen::Vector2d& px : hole) loop.push_back(view.measure(px));
  }
  return loops;
}

/// Coordinate `wanted` of the points that agree with `value` in coordinate `shared`.
std::vector<double> partners(const SpacePolygon& points, int shared, double value, int wanted,
                             double error_mm) {
  std::vector<double> found;
  for (const Vector3d& p : points) {
    if (std::abs(p[shared] - value) <= error_mm) found.push_back(p[wanted]);
  }
  return found;
}

std::optional<double> largest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return *std::max_element(values.begin(), values.end());
}

/// Those of `a` that some of `b` agrees with.
std::vector<double> agreed(const std::vector<double>& a, const std::vector<double>& b,
                           double error_mm) {
  std::vector<double> both;
  for (const double x : a) {
    if (std::any_of(b.begin(), b.end(), [&](double y) { return std::abs(x - y) <= error_mm; })) {
      both.push_back(x);
    }
  }
  return both;
}

/// Largest distance of a corner from the plane through the centroid.
double out_of_plane(const std::vector<SpacePolygon>& loops, const SurfaceAttributes& attributes) {
  double distance = 0;
  for (const SpacePolygon& loop : loops) {
    for (const Vector3d& p : loop) {
      distance = std::max(distance, std::abs((p - attributes.centroid).dot(attributes.normal)));
    }
  }
  return distance;
}

class Crossing {
 public:
  Crossing(const std::array<PlanarView, 3>& views, const MeasuredCorners& corners, double error_mm)
      : views_(views), corners_(corners), error_mm_(error_mm) {}

  /// Fills in the coordinate that the view cannot measure.
  bool complete(ViewRole role, Vector3d* corner) const {
    if (role == ViewRole::kTop) return complete_top(corner);
    const bool side = role == ViewRole::kSide;
    const int shared = side ? kX : kY, wanted = side ? kY : kX;
    std::vector<double> found = partners(corners_[0], shared, (*corner)[shared], wanted, error_mm_);
    if (found.empty()) return false;
    const auto [low, high] = std::minmax_element(found.begin(), found.end());
    const bool camera_is_high = views_[static_cast<std::size_t>(role)].towards[wanted] > 0;
    (*corner)[wanted] = camera_is_high ? *high : *low;
    return true;
  }

 private:
  bool complete_top(Vector3d* corner) const {
    const std::vector<double> side = partners(corners_[1], kX, corner->x(), kZ, error_mm_);
    const std::vector<double> front = partners(corners_[2], kY, corner->y(), kZ, error_mm_);
    std::optional<double> z = largest(agreed(side, front, error_mm_));
    if (!z) z = std::max(largest(side), largest(front));
    if (z) corner->z() = *z;
    return z.has_value();
  }

  const std::array<PlanarView, 3>& views_;
  const MeasuredCorners& corners_;
  double error_mm_;
};

bool is_duplicate(const SurfaceAttributes& k, const SurfaceAttributes& t, const Vector3d& corner) {
  const double e = kDuplicateTolerance;
  return std::abs(k.area - t.area) <= e * k.area &&
         std::abs(k.perimeter - t.perimeter) <= e * k.perimeter &&
         std::abs(k.edges() - t.edges()) <= e * k.edges() &&
         (k.normal - t.normal).norm() <= e * k.normal.norm() &&
         (k.centroid - t.centroid).norm() <= e * (k.centroid - corner).norm();
}

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

MeasuredCorners measure_corners(const std::array<PlanarView, 3>& views,
                                const std::array<std::vector<Region>, 3>& regions) {
  MeasuredCorners corners;
  for (std::size_t v = 0; v < 3; ++v) {
    for (const Region& region : regions[v]) {
      for (const SpacePolygon& loop : measure(views[v], region)) {
        corners[v].insert(corners[v].end(), loop.begin(), loop.end());
      }
    }
  }
  return corners;
}

CrossingResult cross_views(const std::array<PlanarView, 3>& views,
                           const std::array<std::vector<Region>, 3>& regions, double error_mm) {
  const MeasuredCorners corners = measure_corners(views, regions);
  const Crossing crossing(views, corners, error_mm);
  CrossingResult result;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t r = 0; r < regions[v].size(); ++r) {
      CrossedSurface surface{
          views[v].role, static_cast<int>(r), measure(views[v], regions[v][r]), {}};
      bool complete = true;
      for (SpacePolygon& loop : surface.loops) {
        for (Vector3d& corner : loop)
          complete = complete && crossing.complete(surface.role, &corner);
      }
      surface.attributes = surface_attributes(surface.loops);
      if (!complete) {
        ++result.incomplete;
      } else if (out_of_plane(surface.loops, surface.attributes) > kPlanarityErrors * error_mm) {
        ++result.not_planar;
      } else {
        result.surfaces.push_back(std::move(surface));
      }
    }
  }
  return result;
}

std::vector<CrossedSurface> without_duplicates(const std::vector<CrossedSurface>& surfaces,
                                               const Vector3d& table_corner) {
  std::vector<CrossedSurface> kept;
  for (const CrossedSurface& k : surfaces) {
    const bool duplicate = std::any_of(kept.begin(), kept.end(), [&](const CrossedSurface& t) {
      return t.role < k.role && is_duplicate(k.attributes, t.attributes, table_corner);
    });
    if (!duplicate) kept.push_back(k);
  }
  return kept;
}

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
