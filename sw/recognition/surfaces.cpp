// SPDX-License-Identifier: Apache-2.0
#include "recognition/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recognition/surface_visibility.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;

constexpr int kX = 0, kY = 1, kZ = 2;
/// Relative difference up to which two surfaces are the same one (eqs. 9-13).
constexpr double kDuplicateTolerance = 0.20;
/// A true corner is within Error of its place in each coordinate, so within sqrt(3) Error of its
/// plane; the plane itself is known better than that.
constexpr double kPlanarityErrors = 2;
/// A loose piece of contour as long as the front end's 5x5 window is an edge, not noise.
constexpr int kMaxLoosePx = 5;

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

bool is_planar(const CrossedSurface& surface, double error_mm) {
  const SurfaceAttributes& a = surface.attributes;
  for (const SpacePolygon& loop : surface.loops) {
    for (const Vector3d& p : loop) {
      if (std::abs((p - a.centroid).dot(a.normal)) > kPlanarityErrors * error_mm) return false;
    }
  }
  return true;
}

void append_corners(const std::vector<SpacePolygon>& loops, SpacePolygon* corners) {
  for (const SpacePolygon& loop : loops) corners->insert(corners->end(), loop.begin(), loop.end());
}

class Crossing {
 public:
  Crossing(const std::array<PlanarView, 3>& views, const MeasuredCorners& corners, double error_mm)
      : views_(views), corners_(corners), error_mm_(error_mm) {}

  /// Gives every corner its third coordinate and the surface its attributes.
  bool complete(CrossedSurface* surface) const {
    for (SpacePolygon& loop : surface->loops) {
      for (Vector3d& corner : loop) {
        if (!complete(surface->role, &corner)) return false;
      }
    }
    surface->attributes = surface_attributes(surface->loops);
    return true;
  }

 private:
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

void drop_contradicted(const MeasuredCorners& corners, double error_mm, CrossingResult* result) {
  const std::vector<bool> contradicted = contradicted_surfaces(result->surfaces, corners, error_mm);
  std::vector<CrossedSurface> kept;
  for (std::size_t i = 0; i < contradicted.size(); ++i) {
    if (!contradicted[i]) kept.push_back(std::move(result->surfaces[i]));
  }
  result->contradicted = static_cast<int>(contradicted.size() - kept.size());
  result->surfaces = std::move(kept);
}

}  // namespace

MeasuredCorners measure_corners(const std::array<PlanarView, 3>& views,
                                const std::array<std::vector<Region>, 3>& regions) {
  MeasuredCorners corners;
  for (std::size_t v = 0; v < 3; ++v) {
    for (const Region& region : regions[v]) {
      append_corners(measure(views[v], region), &corners[v]);
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
      CrossedSurface surface{views[v].role, int(r), measure(views[v], regions[v][r]), {}};
      int* failed = nullptr;
      if (regions[v][r].loose_px > kMaxLoosePx) {
        failed = &result.in_pieces;
      } else if (!crossing.complete(&surface)) {
        failed = &result.incomplete;
      } else if (!is_planar(surface, error_mm)) {
        failed = &result.not_planar;
      }
      if (failed) {
        ++*failed;
        continue;
      }
      result.surfaces.push_back(std::move(surface));
    }
  }
  drop_contradicted(corners, error_mm, &result);
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

}  // namespace trihedron
