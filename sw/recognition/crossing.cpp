// SPDX-License-Identifier: Apache-2.0
#include "recognition/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The line in which two planes intersect.
struct SpaceLine {
  Vector3d point, direction;
};

std::optional<SpaceLine> intersect(const Plane& a, const Plane& b, double min_sine) {
  const Vector3d d = a.normal.cross(b.normal);
  const double n2 = d.squaredNorm();
  if (n2 < min_sine * min_sine) return std::nullopt;
  const Vector3d p = (b.offset * a.normal - a.offset * b.normal).cross(d) / n2;
  return SpaceLine{p, d / std::sqrt(n2)};
}

/// Position along the line of its point nearest to a ray, mm.
double nearest_along(const SpaceLine& line, const Ray& ray) {
  const Vector3d w = line.point - ray.origin;
  const double b = line.direction.dot(ray.direction);
  const double d = line.direction.dot(w), e = ray.direction.dot(w);
  return (b * e - d) / std::max(1e-9, 1 - b * b);
}

/// One segment as an interval of the common line, mm; `flip`: it runs against the line.
struct Interval {
  double low, high;
  bool flip;
};

Interval interval_on(const SpaceLine& line, const ViewLines& v, std::size_t s) {
  const double t0 = nearest_along(line, v.ideal.ray(v.ends[s][0]));
  const double t1 = nearest_along(line, v.ideal.ray(v.ends[s][1]));
  return {std::min(t0, t1), std::max(t0, t1), t1 < t0};
}

/// px per mm along the line in a view, at x.
double px_per_mm_along(const IdealView& view, const Vector3d& x, const Vector3d& direction) {
  return (view.project(x + direction) - view.project(x)).norm();
}

bool in_front(const ViewLines& v, const Vector3d& x) { return v.ideal.depth(x) > 1e-3; }

/// Whether a view has a segment along most of the edge.
bool confirms(const ViewLines& v, const SpaceEdge& e) {
  if (!in_front(v, e.end[0]) || !in_front(v, e.end[1])) return false;
  const Vector2d q0 = v.ideal.project(e.end[0]), q1 = v.ideal.project(e.end[1]);
  const double length = (q1 - q0).norm();
  if (length < 4) return true;  // seen end-on: it cannot speak against the edge
  constexpr double kTolerancePx = 2;
  for (const Segment& s : v.segments) {
    if (std::abs(s.distance(q0)) > kTolerancePx + 0.02 * length) continue;
    if (std::abs(s.distance(q1)) > kTolerancePx + 0.02 * length) continue;
    const double t0 = s.along(q0), t1 = s.along(q1);
    const double overlap = std::min(s.length, std::max(t0, t1)) - std::max(0.0, std::min(t0, t1));
    if (overlap > 0.5 * std::min(length, s.length)) return true;
  }
  return false;
}

class PairCrosser {
 public:
  PairCrosser(const std::vector<ViewLines>& views, int a, int b, const CrossingOptions& options)
      : views_(views), a_(a), b_(b), options_(options) {}

  void cross(std::vector<SpaceEdge>& out) const {
    for (std::size_t i = 0; i < view(a_).segments.size(); ++i) {
      for (std::size_t j = 0; j < view(b_).segments.size(); ++j) {
        if (auto e = cross_one(i, j)) out.push_back(*e);
      }
    }
  }

 private:
  const ViewLines& view(int v) const { return views_[static_cast<std::size_t>(v)]; }

  std::optional<SpaceEdge> cross_one(std::size_t i, std::size_t j) const {
    const ViewLines &va = view(a_), &vb = view(b_);
    const auto line = intersect(va.planes[i], vb.planes[j], std::sin(options_.min_plane_angle_rad));
    if (!line) return std::nullopt;
    const Interval p = interval_on(*line, va, i), q = interval_on(*line, vb, j);
    const double overlap = std::min(p.high, q.high) - std::max(p.low, q.low);
    if (overlap < options_.min_overlap * std::min(p.high - p.low, q.high - q.low)) {
      return std::nullopt;
    }
    const double low = std::min(p.low, q.low), high = std::max(p.high, q.high);
    SpaceEdge e;
    e.view = {a_, b_};
    e.segment = {static_cast<int>(i), static_cast<int>(j)};
    e.end = {line->point + low * line->direction, line->point + high * line->direction};
    if (!in_front(va, e.end[0]) || !in_front(va, e.end[1]) || !in_front(vb, e.end[0]) ||
        !in_front(vb, e.end[1])) {
      return std::nullopt;
    }
    e.direction = line->direction;
    e.length = high - low;
    const double scale_a = px_per_mm_along(va.ideal, e.end[0], e.direction);
    const double scale_b = px_per_mm_along(vb.ideal, e.end[0], e.direction);
    e.sigma = 1 / std::max(std::min(scale_a, scale_b), 1e-6);
    const double tolerance = options_.end_tolerance_px * e.sigma;
    if (tolerance > 0.3 * e.length) return std::nullopt;  // seen too steeply to say anything
    e.agreed = {std::abs(p.low - q.low) < tolerance, std::abs(p.high - q.high) < tolerance};
    e.end_of = {{{p.flip ? 1 : 0, p.flip ? 0 : 1}, {q.flip ? 1 : 0, q.flip ? 0 : 1}}};
    // Agreed ends lie between the two measurements, nearer to the one that sees more of the edge.
    const double weight = scale_a * scale_a / (scale_a * scale_a + scale_b * scale_b);
    const auto mean = [&](double x, double y) { return weight * x + (1 - weight) * y; };
    if (e.agreed[0]) e.end[0] = line->point + mean(p.low, q.low) * line->direction;
    if (e.agreed[1]) e.end[1] = line->point + mean(p.high, q.high) * line->direction;
    e.length = (e.end[1] - e.end[0]).norm();
    if (!e.agreed[0] && !e.agreed[1]) return std::nullopt;
    return e;
  }

  const std::vector<ViewLines>& views_;
  int a_, b_;
  const CrossingOptions& options_;
};

/// Moves the ends of segments onto their nearest corners and lists the corners of every end.
void attach_corners(ViewLines& v) {
  v.end_corners.resize(v.segments.size());
  for (const Segment& s : v.segments) v.ends.push_back({s.p0, s.p1});
  std::vector<std::array<double, 2>> nearest(v.segments.size(), {1e9, 1e9});
  for (std::size_t c = 0; c < v.corners.size(); ++c) {
    for (int k = 0; k < 2; ++k) {
      if (v.corners[c].through[static_cast<std::size_t>(k)]) continue;
      const auto s = static_cast<std::size_t>(v.corners[c].segment[static_cast<std::size_t>(k)]);
      const Segment& segment = v.segments[s];
      const std::size_t end = segment.along(v.corners[c].p) < 0.5 * segment.length ? 0 : 1;
      v.end_corners[s][end].push_back(static_cast<int>(c));
      const double d = (v.corners[c].p - (end == 0 ? segment.p0 : segment.p1)).norm();
      if (d < nearest[s][end]) {
        nearest[s][end] = d;
        v.ends[s][end] = v.corners[c].p;
      }
    }
  }
}

}  // namespace

ViewLines find_lines(const View& view) {
  ViewLines v{
      IdealView(view.camera), view.features.width, view.features.height, {}, {}, {}, {}, {}};
  v.segments = find_segments(find_edgels(view.features), view.camera);
  for (const Segment& s : v.segments) v.planes.push_back(v.ideal.plane(s.p0, s.p1));
  v.corners = find_corners(v.segments);
  attach_corners(v);
  return v;
}

std::vector<SpaceEdge> cross_edges(const std::vector<ViewLines>& views,
                                   const CrossingOptions& options) {
  std::vector<SpaceEdge> edges;
  for (int a = 0; a < static_cast<int>(views.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(views.size()); ++b) {
      PairCrosser(views, a, b, options).cross(edges);
    }
  }
  for (SpaceEdge& e : edges) {
    for (int v = 0; v < static_cast<int>(views.size()); ++v) {
      if (v == e.view[0] || v == e.view[1]) continue;
      if (confirms(views[static_cast<std::size_t>(v)], e)) ++e.confirmations;
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const SpaceEdge& a, const SpaceEdge& b) {
    if (a.confirmations != b.confirmations) return a.confirmations > b.confirmations;
    return a.length > b.length;
  });
  return edges;
}

}  // namespace trihedron
