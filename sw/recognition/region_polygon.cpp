// SPDX-License-Identifier: Apache-2.0
#include "recognition/region_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

/// A digital line leaves the true one by half a pixel across and half along: the largest
/// distance of a straight chain from its chord, px.
constexpr double kChordTolerancePx = 1.0;
/// Largest distance of a straight chain from its fitted line, px: half a pixel of digitisation
/// and as much for noise and blur.
constexpr double kLineTolerancePx = 0.75;
/// The 5x5 windows of the front end round corners off over this many pixels.
constexpr int kCornerPx = 2;
/// A vertex of the stream belongs to a chain point at most this far away.
constexpr double kProposalPx = 2.5;
/// Shorter sides are rounded corners, not edges.
constexpr int kMinSidePx = 4;
/// Where contours meet, each bends towards the other within a window or two...
constexpr int kMaxRoundingPx = 12;
/// ... by at most this distance.
constexpr double kRoundingPx = 1.5;
/// Sides less than 20 degrees from opposite are those of a slit, not of a sharp corner (cosine).
constexpr double kBack = -0.94;
/// An intersection farther than this from the bend is ill-conditioned: nearly parallel sides.
constexpr double kMaxCornerShiftPx = 6.0;

struct Line {
  Vector2d point, direction;
  double max_residual = 0;
};

/// Points first..last (inclusive, last may exceed the chain's size) without rounded ends.
Line fit_line(const Points& chain, int first, int last) {
  const int n = static_cast<int>(chain.size());
  const int trim = std::min(kCornerPx, (last - first) / 4);
  Vector2d mean = Vector2d::Zero();
  int count = 0;
  for (int i = first + trim; i <= last - trim; ++i, ++count) mean += chain[i % n];
  mean /= count;
  double xx = 0, xy = 0, yy = 0;
  for (int i = first + trim; i <= last - trim; ++i) {
    const Vector2d d = chain[i % n] - mean;
    xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  Line line{mean, {std::cos(angle), std::sin(angle)}};
  for (int i = first + trim; i <= last - trim; ++i) {
    const Vector2d d = chain[i % n] - mean;
    line.max_residual = std::max(line.max_residual,
                                 std::abs(d.x() * line.direction.y() - d.y() * line.direction.x()));
  }
  return line;
}

/// Splits first..last where the chain is farthest from its chord, while that is too far.
void split(const Points& chain, int first, int last, std::vector<int>* bends) {
  const int n = static_cast<int>(chain.size());
  const Vector2d a = chain[first % n], chord = chain[last % n] - a;
  const double length = chord.norm();
  double farthest = kChordTolerancePx;
  int at = -1;
  for (int i = first + 1; i < last; ++i) {
    const Vector2d d = chain[i % n] - a;
    const double distance =
        length > 0 ? std::abs(d.x() * chord.y() - d.y() * chord.x()) / length : d.norm();
    if (distance > farthest) farthest = distance, at = i;
  }
  if (at < 0) return;
  split(chain, first, at, bends);
  bends->push_back(at);
  split(chain, at, last, bends);
}

int farthest_from(const Points& chain, int from) {
  int best = from;
  double distance = 0;
  for (int i = 0; i < static_cast<int>(chain.size()); ++i) {
    const double d = (chain[i] - chain[from]).squaredNorm();
    if (d > distance) distance = d, best = i;
  }
  return best;
}

/// Chain indices where a side may end, ascending.
std::vector<int> find_bends(const Points& chain, const Points& proposals) {
  const int n = static_cast<int>(chain.size());
  const int a = farthest_from(chain, farthest_from(chain, 0));
  const int b = farthest_from(chain, a);
  std::vector<int> bends = {a, b};
  split(chain, std::min(a, b), std::max(a, b), &bends);
  split(chain, std::max(a, b), std::min(a, b) + n, &bends);
  for (const Vector2d& p : proposals) {
    int nearest = -1;
    double distance = kProposalPx * kProposalPx;
    for (int i = 0; i < n; ++i) {
      const double d = (chain[i] - p).squaredNorm();
      if (d < distance) distance = d, nearest = i;
    }
    if (nearest >= 0) bends.push_back(nearest);
  }
  for (int& bend : bends) bend %= n;
  std::sort(bends.begin(), bends.end());
  bends.erase(std::unique(bends.begin(), bends.end()), bends.end());
  return bends;
}

/// Side s runs from bend s to bend s + 1, the last one across the chain's end.
class Sides {
 public:
  Sides(const Points& chain, std::vector<int> bends) : chain_(chain), bends_(std::move(bends)) {}

  int count() const { return static_cast<int>(bends_.size()); }
  int bend(int s) const { return bends_[static_cast<std::size_t>(wrap(s))]; }
  int length(int s) const { return end(s) - bend(s); }
  /// Whether the chain turns back within `count` sides from s on: the end of a slit, which is a
  /// side however short it is.
  bool turns_back(int s, int count) const {
    if (length(s - 1) < kMinSidePx || length(s + count) < kMinSidePx) return false;
    return heading(s - 1).dot(heading(s + count)) < kBack;
  }
  Line line(int s) const { return fit_line(chain_, bend(s), end(s)); }
  /// One line through side s and the next one.
  Line joint_line(int s) const { return fit_line(chain_, bend(s), end(s) + length(s + 1)); }
  /// Length of `count` sides from s on.
  int length(int s, int count) const {
    int sum = 0;
    for (int i = 0; i < count; ++i) sum += length(s + i);
    return sum;
  }
  void remove_bend(int s) { bends_.erase(bends_.begin() + wrap(s)); }
  /// Puts one bend into the middle of `count` sides from s on, in place of theirs.
  void contract(int s, int count) {
    bends_[static_cast<std::size_t>(wrap(s))] =
        (bend(s) + length(s, count) / 2) % static_cast<int>(chain_.size());
    std::vector<int> left;
    for (int i = 0; i < this->count(); ++i) {
      const int after = wrap(i - wrap(s));
      if (after == 0 || after > count) left.push_back(bend(i));
    }
    bends_ = std::move(left);
  }

 private:
  Vector2d heading(int s) const {
    return (chain_[static_cast<std::size_t>(bend(s + 1))] -
            chain_[static_cast<std::size_t>(bend(s))])
        .normalized();
  }
  int wrap(int s) const { return (s % count() + count()) % count(); }
  int end(int s) const {
    const int next = bend(s + 1);
    return next > bend(s) ? next : next + static_cast<int>(chain_.size());
  }
  const Points& chain_;
  std::vector<int> bends_;
};

/// Removes the bend whose two sides one line fits best, while one fits.
void merge_straight(Sides* sides) {
  while (sides->count() > 2) {
    double best = kLineTolerancePx;
    int at = -1;
    for (int s = 0; s < sides->count(); ++s) {
      const double residual = sides->joint_line(s).max_residual;
      if (residual < best) best = residual, at = s;
    }
    if (at < 0) return;
    sides->remove_bend(at + 1);
  }
}

/// Replaces sides too short to be edges by one bend in their middle, shortest first.
void drop_short(Sides* sides) {
  while (sides->count() > 2) {
    int shortest = -1;
    for (int s = 0; s < sides->count(); ++s) {
      if (sides->length(s) >= kMinSidePx || sides->turns_back(s, 1)) continue;
      if (shortest < 0 || sides->length(s) < sides->length(shortest)) shortest = s;
    }
    if (shortest < 0) return;
    sides->contract(shortest, 1);
  }
}

/// Where two lines meet; nothing when they are parallel.
std::optional<Vector2d> meet(const Line& a, const Line& b) {
  const double cross = a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x();
  if (std::abs(cross) < 1e-6) return std::nullopt;
  const Vector2d d = b.point - a.point;
  return a.point + (d.x() * b.direction.y() - d.y() * b.direction.x()) / cross * a.direction;
}

double distance(const Line& line, const Vector2d& p) {
  const Vector2d d = p - line.point;
  return std::abs(d.x() * line.direction.y() - d.y() * line.direction.x());
}

/// Whether the `count` sides from s on are only the rounding of the corner where their neighbours
/// meet: short, and along one or the other of them.
bool is_rounding(const Points& chain, const Sides& sides, int s, int count) {
  const int length = sides.length(s, count);
  if (length > kMaxRoundingPx || sides.turns_back(s, count)) return false;
  const Line before = sides.line(s - 1), after = sides.line(s + count);
  if (!meet(before, after)) return false;
  for (int i = 0; i <= length; ++i) {
    const Vector2d& p = chain[static_cast<std::size_t>(sides.bend(s) + i) % chain.size()];
    if (std::min(distance(before, p), distance(after, p)) > kRoundingPx) return false;
  }
  return true;
}

/// Replaces roundings by one bend in their middle.
void drop_roundings(const Points& chain, Sides* sides) {
  for (int count = 1; count <= 3; ++count) {
    for (int s = 0; s < sides->count() && sides->count() - count >= 3;) {
      if (!is_rounding(chain, *sides, s, count)) {
        ++s;
        continue;
      }
      sides->contract(s, count);
      s = 0;
    }
  }
}

Vector2d corner(const Line& a, const Line& b, const Vector2d& bend) {
  const auto crossing = meet(a, b);
  return crossing && (*crossing - bend).norm() <= kMaxCornerShiftPx ? *crossing : bend;
}

}  // namespace

ImagePolygon fit_polygon(const Points& chain, const Points& proposals) {
  if (chain.size() < 3 * kMinSidePx) return {};
  Sides sides(chain, find_bends(chain, proposals));
  drop_short(&sides);
  merge_straight(&sides);
  drop_roundings(chain, &sides);
  if (sides.count() < 3) return {};
  ImagePolygon polygon;
  for (int s = 0; s < sides.count(); ++s) {
    const Vector2d& bend = chain[static_cast<std::size_t>(sides.bend(s))];
    polygon.push_back(corner(sides.line(s - 1), sides.line(s), bend));
  }
  return polygon;
}

double signed_area(const ImagePolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& a = polygon[i];
    const Vector2d& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

}  // namespace trihedron
