// SPDX-License-Identifier: Apache-2.0
#include "recognition/segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace trihedron {
namespace {

using Eigen::Vector2d;

/// Weighted moments of points: enough to fit a line and to update the fit in O(1).
struct Moments {
  double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  void add(const Vector2d& p, double weight) {
    w += weight;
    x += weight * p.x();
    y += weight * p.y();
    xx += weight * p.x() * p.x();
    xy += weight * p.x() * p.y();
    yy += weight * p.y() * p.y();
  }
};

struct Line {
  Vector2d centre, direction;
};

/// Mean squared distance across the best line, px^2; 0 without points.
double fit_residual_squared(const Moments& m) {
  if (m.w <= 0) return 0;
  const double x = m.x / m.w, y = m.y / m.w;
  const double sxx = m.xx / m.w - x * x, syy = m.yy / m.w - y * y, sxy = m.xy / m.w - x * y;
  const double spread = std::sqrt((sxx - syy) * (sxx - syy) + 4 * sxy * sxy);
  return std::max(0.0, 0.5 * (sxx + syy - spread));
}

Line fit(const Moments& m) {
  const Vector2d c(m.x / m.w, m.y / m.w);
  const double sxx = m.xx / m.w - c.x() * c.x(), syy = m.yy / m.w - c.y() * c.y();
  const double sxy = m.xy / m.w - c.x() * c.y();
  // Half the angle whose cosine and sine are (sxx - syy, 2 sxy) / spread, without the angle.
  const double d = sxx - syy, spread = std::sqrt(d * d + 4 * sxy * sxy);
  if (spread <= 0) return {c, Vector2d::UnitX()};
  const double larger = std::sqrt(0.5 * (1 + std::abs(d) / spread));
  const double smaller = sxy / (spread * larger);
  if (d >= 0) return {c, {larger, smaller}};
  return {c, {std::abs(smaller), std::copysign(larger, sxy)}};
}

Vector2d position(const Edgel& e) { return {e.x, e.y}; }
Vector2d gradient(const Edgel& e) { return {e.nx, e.ny}; }
/// Strong points localise better, but beyond some strength calibration and sampling dominate.
double weight(const Edgel& e) { return std::min(e.strength, 20.0F); }

/// Grows one segment at a time over the edge points that no earlier segment took.
class Grower {
 public:
  Grower(const EdgelMap& map, const SegmentOptions& options)
      : map_(map), options_(options), used_(map.edgels.size(), 0) {}

  bool used(int i) const { return used_[static_cast<std::size_t>(i)] != 0; }

  /// The members of the segment through a seed; they are taken until released.
  const std::vector<int>& grow(int seed) {
    const Edgel& e = edgel(seed);
    members_.clear();
    moments_ = {};
    line_ = {position(e), {e.ny, -e.nx}};
    add(seed);
    run(+1);
    run(-1);
    run(+1);  // the refined line may now pass what stopped the first run
    return members_;
  }

  /// Gives the last segment's points back, but for its seed, which would only find them again.
  void release() {
    for (std::size_t i = 1; i < members_.size(); ++i) {
      used_[static_cast<std::size_t>(members_[i])] = 0;
    }
  }

 private:
  const Edgel& edgel(int i) const { return map_.edgels[static_cast<std::size_t>(i)]; }
  /// The line's normal points to the bright side: its direction keeps its sign.
  Vector2d normal() const { return {-line_.direction.y(), line_.direction.x()}; }

  void add(int i) {
    used_[static_cast<std::size_t>(i)] = 1;
    members_.push_back(i);
    moments_.add(position(edgel(i)), weight(edgel(i)));
    if (members_.size() < 4) return;  // the seed's tangent is better than a fit of so few
    const Line next = fit(moments_);
    const double sign = next.direction.dot(line_.direction) < 0 ? -1 : 1;
    line_ = {next.centre, sign * next.direction};
  }

  void run(int sign) {
    double s = 0;
    for (const int i : members_) {
      s = std::max(s, sign * line_.direction.dot(position(edgel(i)) - line_.centre));
    }
    for (int gap = 0; gap <= options_.max_gap_px;) {
      s += 1;
      const std::size_t before = members_.size();
      absorb(line_.centre + sign * s * line_.direction);
      gap = members_.size() > before ? 0 : gap + 1;
      for (std::size_t i = before; i < members_.size(); ++i) {
        s = std::max(s, sign * line_.direction.dot(position(edgel(members_[i])) - line_.centre));
      }
    }
  }

  /// Takes the free edge points of the line in the 3x3 pixels around p.
  void absorb(const Vector2d& p) {
    const int px = static_cast<int>(std::lround(p.x())), py = static_cast<int>(std::lround(p.y()));
    if (px < 1 || py < 1 || px + 1 >= map_.width || py + 1 >= map_.height) return;
    for (int y = py - 1; y <= py + 1; ++y) {
      for (int x = px - 1; x <= px + 1; ++x) {
        const int i = map_.at(x, y);
        if (i >= 0 && !used(i) && fits(edgel(i))) add(i);
      }
    }
  }

  bool fits(const Edgel& e) const {
    // A young line's direction is as uncertain as one gradient; it gets more room.
    const double room = (members_.size() < 6 ? 1.5 : 1.0) * options_.max_distance_px;
    return std::abs(normal().dot(position(e) - line_.centre)) < room &&
           gradient(e).dot(normal()) > options_.min_cosine;
  }

  const EdgelMap& map_;
  const SegmentOptions& options_;
  std::vector<char> used_;
  std::vector<int> members_;
  Moments moments_;
  Line line_;
};

/// Edge points of some strength by decreasing strength; ties in raster order.
std::vector<int> seeds_of(const EdgelMap& map, float min_strength) {
  const auto strength = [&](int i) { return map.edgels[static_cast<std::size_t>(i)].strength; };
  std::vector<int> seeds;
  for (int i = 0; i < static_cast<int>(map.edgels.size()); ++i) {
    if (strength(i) >= min_strength) seeds.push_back(i);
  }
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](int a, int b) { return strength(a) > strength(b); });
  return seeds;
}

/// An edge point in the undistorted image, with its place along the segment it was found on.
struct Point {
  Vector2d p;
  double along, weight, strength;
};

/// Edge points of a segment in order along it.
std::vector<Point> ordered_points(const EdgelMap& map, const std::vector<int>& members,
                                  const Camera& camera) {
  const Edgel& seed = map.edgels[static_cast<std::size_t>(members.front())];
  std::vector<Point> out;
  out.reserve(members.size());
  for (const int i : members) {
    const Edgel& e = map.edgels[static_cast<std::size_t>(i)];
    const Vector2d p = camera.undistort(position(e));
    out.push_back({p, seed.ny * p.x() - seed.nx * p.y(), weight(e), e.strength});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Point& a, const Point& b) { return a.along < b.along; });
  return out;
}

Moments moments(const std::vector<Point>& points) {
  Moments m;
  for (const Point& p : points) m.add(p.p, p.weight);
  return m;
}

/// The segment through points in order along it.
Segment make_segment(const std::vector<Point>& points) {
  const Moments m = moments(points);
  const Line line = fit(m);
  Segment s;
  s.direction = line.direction;
  if (line.direction.dot(points.back().p - points.front().p) < 0) s.direction = -s.direction;
  s.normal = {-s.direction.y(), s.direction.x()};
  double low = 0, high = 0;
  for (const Point& p : points) {
    low = std::min(low, s.direction.dot(p.p - line.centre));
    high = std::max(high, s.direction.dot(p.p - line.centre));
    s.strength += p.strength;
  }
  s.p0 = line.centre + low * s.direction;
  s.p1 = line.centre + high * s.direction;
  s.length = high - low;
  s.support = static_cast<int>(points.size());
  s.strength /= s.support;
  // Neighbouring points share the pixels of the 5x5 masks and the 3x3 smoothing: about every
  // third is independent. Sampling leaves 0.1 px even without noise.
  const double rms = std::max(std::sqrt(fit_residual_squared(m)), 0.1);
  s.offset_sigma = rms / std::sqrt(std::max(1.0, s.support / 3.0));
  s.angle_sigma = s.offset_sigma * std::sqrt(12.0) / std::max(s.length, 1.0);
  return s;
}

/// Where two lines fit the points best: the first index of the second.
std::size_t best_bend(const std::vector<Point>& points, std::size_t margin) {
  std::vector<double> error(points.size(), 0);
  const auto sum = [](const Moments& m) { return m.w * fit_residual_squared(m); };
  Moments m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    error[i] += sum(m);
    m.add(points[i].p, points[i].weight);
  }
  m = {};
  for (std::size_t i = points.size(); i-- > 0;) {
    m.add(points[i].p, points[i].weight);
    error[i] += sum(m);
  }
  const auto from = error.begin() + static_cast<std::ptrdiff_t>(margin);
  const auto to = error.end() - static_cast<std::ptrdiff_t>(margin);
  return static_cast<std::size_t>(std::min_element(from, to) - error.begin());
}

/// Appends the segment through the points; two where they bend significantly.
void append_segments(const std::vector<Point>& points, double min_length_px,
                     std::vector<Segment>& out) {
  constexpr std::size_t kMargin = 6;     // points that a direction needs
  constexpr double kSignificance = 4;    // sigmas of the angle between the parts
  constexpr double kMinBendRad = 0.015;  // remainders of distortion bend as much
  if (points.size() >= 2 * kMargin + 1) {
    const auto bend = points.begin() + static_cast<std::ptrdiff_t>(best_bend(points, kMargin));
    const std::vector<Point> first(points.begin(), bend), second(bend, points.end());
    const Segment a = make_segment(first), b = make_segment(second);
    const double angle = std::abs(a.normal.dot(b.direction));
    if (a.length >= min_length_px && b.length >= min_length_px && angle > kMinBendRad &&
        angle > kSignificance * std::hypot(a.angle_sigma, b.angle_sigma)) {
      append_segments(first, min_length_px, out);
      append_segments(second, min_length_px, out);
      return;
    }
  }
  const Segment s = make_segment(points);
  if (s.length >= min_length_px) out.push_back(s);
}

}  // namespace

std::vector<Segment> find_segments(const EdgelMap& edgels, const Camera& camera,
                                   const SegmentOptions& options) {
  std::vector<Segment> segments;
  Grower grower(edgels, options);
  for (const int seed : seeds_of(edgels, options.min_seed_strength)) {
    if (grower.used(seed)) continue;
    const std::vector<int>& members = grower.grow(seed);
    double evidence = 0;
    for (const int i : members) evidence += edgels.edgels[static_cast<std::size_t>(i)].strength;
    const std::size_t before = segments.size();
    if (evidence >= options.min_evidence && members.size() >= 4) {
      append_segments(ordered_points(edgels, members, camera), options.min_length_px, segments);
    }
    if (segments.size() == before) grower.release();
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.length > b.length; });
  return segments;
}

}  // namespace trihedron
