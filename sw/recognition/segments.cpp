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
  double residual = 0;  ///< rms across the line, px
};

Line fit(const Moments& m) {
  const Vector2d c(m.x / m.w, m.y / m.w);
  const double sxx = m.xx / m.w - c.x() * c.x(), syy = m.yy / m.w - c.y() * c.y();
  const double sxy = m.xy / m.w - c.x() * c.y();
  const double angle = 0.5 * std::atan2(2 * sxy, sxx - syy);
  const double across = 0.5 * (sxx + syy - std::hypot(sxx - syy, 2 * sxy));
  return {c, {std::cos(angle), std::sin(angle)}, std::sqrt(std::max(0.0, across))};
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
    line_ = {position(e), {e.ny, -e.nx}, 0};
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
    line_ = {next.centre, sign * next.direction, next.residual};
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

/// The segment through some edge points, in the undistorted image.
Segment make_segment(const EdgelMap& map, const std::vector<int>& members, const Camera& camera) {
  Moments m;
  std::vector<Vector2d> points;
  points.reserve(members.size());
  const Edgel& seed = map.edgels[static_cast<std::size_t>(members.front())];
  Segment s;
  for (const int i : members) {
    const Edgel& e = map.edgels[static_cast<std::size_t>(i)];
    points.push_back(camera.undistort(position(e)));
    m.add(points.back(), weight(e));
    s.strength += e.strength;
  }
  const Line line = fit(m);
  s.direction = line.direction;
  if (line.direction.dot(Vector2d(seed.ny, -seed.nx)) < 0) s.direction = -s.direction;
  s.normal = {-s.direction.y(), s.direction.x()};
  double low = 0, high = 0;
  for (const Vector2d& p : points) {
    low = std::min(low, s.direction.dot(p - line.centre));
    high = std::max(high, s.direction.dot(p - line.centre));
  }
  s.p0 = line.centre + low * s.direction;
  s.p1 = line.centre + high * s.direction;
  s.length = high - low;
  s.support = static_cast<int>(members.size());
  s.strength /= s.support;
  // Neighbouring points share the pixels of the 5x5 masks and the 3x3 smoothing: about every
  // third is independent. Sampling leaves 0.1 px even without noise.
  const double rms = std::max(line.residual, 0.1);
  s.offset_sigma = rms / std::sqrt(std::max(1.0, s.support / 3.0));
  s.angle_sigma = s.offset_sigma * std::sqrt(12.0) / std::max(s.length, 1.0);
  return s;
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
    if (evidence >= options.min_evidence && members.size() >= 4) {
      const Segment s = make_segment(edgels, members, camera);
      if (s.length >= options.min_length_px) {
        segments.push_back(s);
        continue;
      }
    }
    grower.release();
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.length > b.length; });
  return segments;
}

}  // namespace trihedron
