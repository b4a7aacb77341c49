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

/// px per mm along the line in a view, at x.
double px_per_mm_along(const IdealView& view, const Vector3d& x, const Vector3d& direction) {
  return (view.project(x + direction) - view.project(x)).norm();
}

bool in_front(const ViewLines& v, const Vector3d& x) { return v.ideal.depth(x) > 1e-3; }

/// The segment of a view that runs along most of the edge, or -1.
int find_along(const ViewLines& v, const SpaceEdge& e) {
  if (!in_front(v, e.end[0]) || !in_front(v, e.end[1])) return -1;
  const Vector2d q0 = v.ideal.project(e.end[0]), q1 = v.ideal.project(e.end[1]);
  const double length = (q1 - q0).norm();
  constexpr double kTolerancePx = 2, kMinLengthPx = 6;
  if (length < kMinLengthPx) return -1;
  int found = -1;
  double best = 0.5 * length;
  for (std::size_t i = 0; i < v.segments.size(); ++i) {
    const Segment& s = v.segments[i];
    if (std::abs(s.distance(q0)) > kTolerancePx || std::abs(s.distance(q1)) > kTolerancePx) {
      continue;
    }
    const double t0 = s.along(q0), t1 = s.along(q1);
    const double overlap = std::min(s.length, std::max(t0, t1)) - std::max(0.0, std::min(t0, t1));
    if (overlap <= best) continue;
    best = overlap;
    found = static_cast<int>(i);
  }
  return found;
}

struct Interval {
  double low, high;  ///< positions along a common line, mm
};

/// Crosses the segments of two views.
class PairCrosser {
 public:
  PairCrosser(const std::vector<ViewLines>& views, std::size_t a, std::size_t b,
              const CrossingOptions& options)
      : views_(views),
        a_(a),
        b_(b),
        tolerance_px_(options.end_tolerance_px),
        min_sine_(std::sin(options.min_plane_angle_rad)),
        one_view_ends_(options.one_view_ends) {}

  void cross(std::vector<SpaceEdge>& out) {
    for (std::size_t i = 0; i < views_[a_].segments.size(); ++i) {
      for (std::size_t j = 0; j < views_[b_].segments.size(); ++j) cross_one(i, j, out);
    }
  }

 private:
  void cross_one(std::size_t i, std::size_t j, std::vector<SpaceEdge>& out) {
    segment_a_ = i;
    segment_b_ = j;
    const auto line = intersect(views_[a_].planes[i], views_[b_].planes[j], min_sine_);
    if (!line) {
      cross_flat(out);
      return;
    }
    line_ = *line;
    const Interval p = positions(views_[a_].stops[i], along_a_);
    const Interval q = positions(views_[b_].stops[j], along_b_);
    const double low = std::max(p.low, q.low), high = std::min(p.high, q.high);
    if (high <= low || !set_scales(low, high)) return;
    const double tolerance = tolerance_px_ * mm_per_px_;
    const double shortest = tolerance / kSteepest;
    if (high - low < shortest) return;
    agree(views_[a_].stops[i], views_[b_].stops[j], tolerance);
    add_corners(views_[a_].stops[i], along_a_, q, tolerance);
    add_corners(views_[b_].stops[j], along_b_, p, tolerance);
    for (std::size_t k = 0; k < agreed_.size(); ++k) {
      for (std::size_t l = k + 1; l < agreed_.size(); ++l) {
        if (agreed_[l] - agreed_[k] >= shortest) emit(agreed_[k], agreed_[l], true, true, out);
      }
    }
    if (agreed_.empty()) return;
    if (agreed_.back() < high - tolerance && high - agreed_[0] >= shortest) {
      for (const double t : agreed_) emit(t, high, true, false, out);
    }
    if (agreed_[0] > low + tolerance && agreed_.back() - low >= shortest) {
      for (const double t : agreed_) emit(low, t, false, true, out);
    }
  }

  /// Two views that look along one plane, say at a level edge from two sides, do not see where in
  /// the plane the edge lies; but the rays of its ends meet.
  void cross_flat(std::vector<SpaceEdge>& out) {
    const std::vector<Stop>& stops_a = views_[a_].stops[segment_a_];
    const std::vector<Stop>& stops_b = views_[b_].stops[segment_b_];
    meetings_.clear();
    for (std::size_t k = 0; k < stops_a.size(); ++k) {
      for (std::size_t l = 0; l < stops_b.size(); ++l) {
        if (!stops_a[k].end && !stops_b[l].end) continue;
        if (const auto x = meet(stops_a[k].ray, stops_b[l].ray)) meetings_.push_back({k, l, *x});
      }
    }
    for (std::size_t p = 0; p < meetings_.size(); ++p) {
      for (std::size_t q = p + 1; q < meetings_.size(); ++q) {
        const Meeting &m = meetings_[p], &n = meetings_[q];
        // The whole of one segment: its stops 0 and 1 are its ends.
        if ((m.a + n.a == 1 && m.b != n.b) || (m.b + n.b == 1 && m.a != n.a)) {
          emit_between(m.x, n.x, out);
        }
      }
    }
  }

  /// Where two rays meet within the tolerance.
  std::optional<Vector3d> meet(const Ray& a, const Ray& b) const {
    const SpaceLine line{a.origin, a.direction};
    constexpr double kMinSine2 = 0.01;  // rays closer to parallel (6 degrees) meet anywhere
    if (a.direction.cross(b.direction).squaredNorm() < kMinSine2) return std::nullopt;
    const Vector3d x = a.origin + nearest_along(line, b) * a.direction;
    const Vector3d w = x - b.origin;
    const Vector3d y = b.origin + b.direction.dot(w) * b.direction;
    if (!in_front(views_[a_], x) || !in_front(views_[b_], y)) return std::nullopt;
    const double scale = std::min(views_[a_].ideal.px_per_mm(x), views_[b_].ideal.px_per_mm(y));
    if ((x - y).norm() * scale > tolerance_px_) return std::nullopt;
    return Vector3d(0.5 * (x + y));
  }

  void emit_between(const Vector3d& x, const Vector3d& y, std::vector<SpaceEdge>& out) {
    const double length = (y - x).norm();
    if (length < 1e-6) return;
    line_ = {x, (y - x) / length};
    if (!set_scales(0, length) || length < tolerance_px_ * mm_per_px_ / kSteepest) return;
    emit(0, length, true, true, out);
    out.back().flat = true;
  }

  /// Positions of a segment's stops along the line; the interval between its ends.
  Interval positions(const std::vector<Stop>& stops, std::vector<double>& along) const {
    along.resize(stops.size());
    for (std::size_t k = 0; k < stops.size(); ++k) along[k] = nearest_along(line_, stops[k].ray);
    return {std::min(along[0], along[1]), std::max(along[0], along[1])};
  }

  /// False when the line's common piece lies behind a camera.
  bool set_scales(double low, double high) {
    const Vector3d x = line_.point + low * line_.direction,
                   y = line_.point + high * line_.direction;
    for (const std::size_t v : {a_, b_}) {
      if (!in_front(views_[v], x) || !in_front(views_[v], y)) return false;
    }
    const double a = px_per_mm_along(views_[a_].ideal, x, line_.direction);
    const double b = px_per_mm_along(views_[b_].ideal, x, line_.direction);
    mm_per_px_ = 1 / std::max(std::min(a, b), 1e-6);
    weight_a_ = a * a / (a * a + b * b);
    end_mm_per_px_ = 1 / std::max(std::sqrt(a * a + b * b), 1e-6);
    return true;
  }

  /// Where both views see the edge end; one of them may see a corner instead.
  void agree(const std::vector<Stop>& stops_a, const std::vector<Stop>& stops_b, double tolerance) {
    agreed_.clear();
    for (std::size_t k = 0; k < along_a_.size(); ++k) {
      for (std::size_t l = 0; l < along_b_.size(); ++l) {
        if (!stops_a[k].end && !stops_b[l].end) continue;
        if (std::abs(along_a_[k] - along_b_[l]) > tolerance) continue;
        agreed_.push_back(weight_a_ * along_a_[k] + (1 - weight_a_) * along_b_[l]);
      }
    }
    std::sort(agreed_.begin(), agreed_.end());
    const auto near = [&](double x, double y) { return y - x < 0.5 * tolerance; };
    agreed_.erase(std::unique(agreed_.begin(), agreed_.end(), near), agreed_.end());
  }

  /// Ends in corners that the other view does not reach.
  void add_corners(const std::vector<Stop>& stops, const std::vector<double>& along,
                   const Interval& other, double tolerance) {
    for (std::size_t k = 0; one_view_ends_ && k < along.size(); ++k) {
      const bool beyond = along[k] < other.low - tolerance || along[k] > other.high + tolerance;
      if (stops[k].corner && beyond) agreed_.push_back(along[k]);
    }
    std::sort(agreed_.begin(), agreed_.end());
  }

  void emit(double low, double high, bool low_agreed, bool high_agreed,
            std::vector<SpaceEdge>& out) const {
    SpaceEdge e;
    e.segment.assign(views_.size(), -1);
    e.segment[a_] = static_cast<int>(segment_a_);
    e.segment[b_] = static_cast<int>(segment_b_);
    e.end = {line_.point + low * line_.direction, line_.point + high * line_.direction};
    e.agreed = {low_agreed, high_agreed};
    e.direction = line_.direction;
    e.length = high - low;
    e.mm_per_px = mm_per_px_;
    e.end_mm_per_px = end_mm_per_px_;
    out.push_back(std::move(e));
  }

  struct Meeting {
    std::size_t a, b;  ///< a stop of each view,
    Vector3d x;        ///< and the point that both may show
  };
  /// Part of an edge's length that the tolerance may be: beyond, any of its points could be its
  /// end.
  static constexpr double kSteepest = 0.3;

  const std::vector<ViewLines>& views_;
  std::size_t a_, b_;
  double tolerance_px_, min_sine_;
  bool one_view_ends_;
  SpaceLine line_;
  std::size_t segment_a_ = 0, segment_b_ = 0;
  double mm_per_px_ = 0, end_mm_per_px_ = 0, weight_a_ = 0;
  std::vector<double> along_a_, along_b_, agreed_;
  std::vector<Meeting> meetings_;
};

/// Fills in the segments of the views that were not crossed.
void confirm(const std::vector<ViewLines>& views, SpaceEdge& e) {
  for (std::size_t v = 0; v < views.size(); ++v) {
    if (e.segment[v] >= 0) continue;
    e.segment[v] = find_along(views[v], e);
    if (e.segment[v] >= 0) ++e.confirmations;
  }
}

/// Whether two candidates are one: the same segments in all views and ends that agree.
bool same(const SpaceEdge& a, const SpaceEdge& b) {
  if (a.segment != b.segment || a.flat != b.flat) return false;
  const double limit = 3 * std::max(a.mm_per_px, b.mm_per_px);
  const std::size_t flip = a.direction.dot(b.direction) < 0 ? 1 : 0;
  for (const std::size_t k : {0U, 1U}) {
    const std::size_t l = k ^ flip;
    if (a.agreed[k] != b.agreed[l] || (a.end[k] - b.end[l]).norm() > limit) return false;
  }
  return true;
}

}  // namespace

std::vector<SpaceEdge> cross_edges(const std::vector<ViewLines>& views,
                                   const CrossingOptions& options) {
  std::vector<SpaceEdge> edges;
  for (std::size_t a = 0; a < views.size(); ++a) {
    for (std::size_t b = a + 1; b < views.size(); ++b) {
      PairCrosser(views, a, b, options).cross(edges);
    }
  }
  for (SpaceEdge& e : edges) confirm(views, e);
  // Of one edge crossed from several pairs of views, the best seen comes first and stays.
  std::stable_sort(edges.begin(), edges.end(), [](const SpaceEdge& a, const SpaceEdge& b) {
    if (a.segment != b.segment) return a.segment < b.segment;
    return a.mm_per_px < b.mm_per_px;
  });
  std::vector<SpaceEdge> out;
  for (SpaceEdge& e : edges) {
    bool known = false;
    for (auto k = out.rbegin(); k != out.rend() && k->segment == e.segment && !known; ++k) {
      known = same(*k, e);
    }
    if (!known) out.push_back(std::move(e));
  }
  std::stable_sort(out.begin(), out.end(), [](const SpaceEdge& a, const SpaceEdge& b) {
    if (a.confirmations != b.confirmations) return a.confirmations > b.confirmations;
    return a.length > b.length;
  });
  return out;
}

}  // namespace trihedron
