// SPDX-License-Identifier: Apache-2.0
#include "recognition/corner_matcher.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Rotations that turn a corner's first edge onto a direction and its second one into a plane.
class Rotations {
 public:
  /// `direction` and the plane's normal `n` have unit length.
  Rotations(const Vector3d& direction, const Vector3d& n)
      : direction_(direction), u_(direction.unitOrthogonal()), w_(direction.cross(u_)) {
    const double a = n.dot(u_), b = n.dot(w_), rho = std::sqrt(a * a + b * b);
    // The plane turns with the edge: every roll would do.
    constexpr double kMinTilt = 0.05;
    possible_ = rho >= kMinTilt;
    middle_ = Vector2d(a, b) / rho;
    lean_ = n.dot(direction) / rho;
  }

  /// Calls the visitor with each corner frame.
  template <typename Visitor>
  void of(const CornerShape& shape, Visitor&& visitor) const {
    const double q = -shape.cosine / shape.sine * lean_;
    constexpr double kGrazing = 1.02;  // a plane that the second edge misses by a few degrees
    if (!possible_ || !(std::abs(q) <= kGrazing)) return;
    // Roll angles middle +- half, by their cosines and sines.
    const double cos_half = std::clamp(q, -1.0, 1.0), sin_half = std::sqrt(1 - cos_half * cos_half);
    for (const double s : {sin_half, -sin_half}) {
      const Vector3d side = (middle_.x() * cos_half - middle_.y() * s) * u_ +
                            (middle_.y() * cos_half + middle_.x() * s) * w_;
      Matrix3d frame;
      frame << direction_, side, direction_.cross(side);
      visitor(frame);
    }
  }

 private:
  Vector3d direction_, u_, w_;  ///< right-handed
  bool possible_;
  Vector2d middle_;  ///< cosine and sine of the roll at which the plane's normal points sideways
  double lean_ = 0;  ///< of the direction out of the plane
};

/// How far along `d` from x, mm, the image moves `px` along the unit vector `leaving`; never: no
/// point of the line does.
double length_for(const IdealView& view, const Vector3d& x, const Vector3d& d,
                  const Vector2d& leaving, double px) {
  const auto& P = view.matrix();
  const Vector3d at = P.leftCols<3>() * x + P.col(3), along = P.leftCols<3>() * d;
  const double goal = leaving.dot(at.head<2>()) / at.z() + px;
  const double rate = leaving.dot(along.head<2>()) - goal * along.z();
  return rate > 0 ? (goal * at.z() - leaving.dot(at.head<2>())) / rate : kNever;
}

}  // namespace

/// Makes x the corner's place.
void CornerMatcher::look_from(const Vector3d& x) {
  x_ = x;
  sights_.clear();
  for (const ViewLines& v : views_) sights_.push_back(v.ideal.sight(x));
  sights_in_corner_.resize(views_.size());
  nothing_.assign(views_.size(), 0.0);
}

/// Whether one of the surfaces at an edge of the corner turns to the view.
bool CornerMatcher::seen_by(const std::array<Vector3d, 2>& normals, std::size_t view) const {
  const Vector3d& sight = sights_in_corner_[view];
  return normals[0].dot(sight) < 0 || normals[1].dot(sight) < 0;
}

/// Whether an edge could be seen by all views that show it.
bool CornerMatcher::seen_by_all(const std::array<Vector3d, 2>& normals, const SpaceEdge& e) const {
  for (std::size_t v = 0; v < views_.size(); ++v) {
    if (e.segment[v] >= 0 && !seen_by(normals, v)) return false;
  }
  return true;
}

/// Asks along one of the corner's edges, in the views that could see it, what lies beyond the
/// lengths that are `known`.
void CornerMatcher::ask(std::size_t edge, const CornerShape& shape, const Vector3d& direction,
                        double length, const Starts& known) {
  starts_ = known;
  for (std::size_t v = 0; v < views_.size(); ++v) {
    if (!seen_by(shape.normals[edge], v)) starts_[v] = kNever;
  }
  evidence_.ask_along(x_, frame_ * direction, starts_, length, spokes_[edge]);
}

/// Collects the corners whose edges are likelier there than by chance, as often as chance is asked:
/// of all corners in the library less than one passes by accident.
void CornerMatcher::compare(const CornerShape& shape, const Range& corners, double least_second) {
  ask(2, shape, shape.third, shape.longest.third, nothing_);
  const auto frame = static_cast<std::uint32_t>(frames_.size());
  frames_.push_back(frame_);
  for (std::size_t i = corners.first; i < corners.second; ++i) {
    const CornerLengths& l = index_.lengths(i);
    if (l.second < least_second) continue;
    const float sum =
        spokes_[0].evidence(l.first) + spokes_[1].evidence(l.second) + spokes_[2].evidence(l.third);
    if (sum >= least_evidence_) candidates_.push_back({sum, frame, static_cast<std::uint32_t>(i)});
  }
}

/// Offers the poses of the best corners that were collected.
void CornerMatcher::offer_best() {
  const auto count = static_cast<std::size_t>(options_.best_corners);
  if (candidates_.size() > count) {
    const auto last = candidates_.begin() + static_cast<std::ptrdiff_t>(count);
    // Equal ones by their places, so that the choice is the same everywhere.
    std::nth_element(candidates_.begin(), last, candidates_.end(),
                     [](const Candidate& a, const Candidate& b) {
                       if (a.evidence != b.evidence) return a.evidence > b.evidence;
                       return a.frame != b.frame ? a.frame < b.frame : a.corner < b.corner;
                     });
    candidates_.erase(last, candidates_.end());
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.frame != b.frame ? a.frame < b.frame : a.corner < b.corner;
    });
  }
  for (const Candidate& candidate : candidates_) {
    const ModelCorner& c = index_.corner(candidate.corner);
    const Matrix3d R = frames_[candidate.frame] * c.model_from_corner.transpose();
    pool_.add(c.model, {R, x_ - R * c.position});
  }
  candidates_.clear();
  frames_.clear();
}

void CornerMatcher::match_whole(const EdgeEnd& whole, const Neighbour& n) {
  const SpaceEdge& e = *whole.edge;
  look_from(whole.x());
  const auto view = static_cast<std::size_t>(n.view);
  const double tolerance = options_.length_tolerance_px * e.end_mm_per_px;
  const Rotations rotations(whole.leaving(), n.plane.normal);
  spokes_[0] = {};  // its length is known
  Starts known(views_.size(), 0.0);
  for (std::size_t i = 0; i < index_.shapes().size(); ++i) {
    const Range corners = index_.corners_between(i, e.length - tolerance, e.length + tolerance);
    if (corners.first == corners.second) continue;
    const CornerShape& shape = index_.shapes()[i];
    rotations.of(shape, [&](const Matrix3d& frame) {
      frame_ = frame;
      for (std::size_t v = 0; v < views_.size(); ++v) {
        sights_in_corner_[v] = frame.transpose() * sights_[v];
      }
      if (!seen_by(shape.normals[1], view) || !seen_by_all(shape.normals[0], e)) return;
      const Vector3d second(shape.cosine, shape.sine, 0);
      const IdealView& ideal = views_[view].ideal;
      double least = 0;
      known[view] = 0;
      if (!n.through) {
        const double short_px = n.extent - options_.length_tolerance_px;
        if (short_px > 0) least = length_for(ideal, x_, frame * second, n.leaving, short_px);
        known[view] = length_for(ideal, x_, frame * second, n.leaving, n.extent);
      }
      if (least > shape.longest.second) return;
      ask(1, shape, second, shape.longest.second, known);
      compare(shape, corners, least);
    });
  }
  offer_best();
}

void CornerMatcher::match_corner(const EdgeEnd& a, const EdgeEnd& b) {
  const Vector3d da = a.leaving(), db = b.leaving();
  const double angle = std::acos(std::clamp(da.dot(db), -1.0, 1.0));
  constexpr double kMinSine = 0.2;  // else the normal is too uncertain
  if (std::sin(angle) < kMinSine) return;
  const double tolerance =
      options_.length_tolerance_px * std::max(a.edge->mm_per_px, b.edge->mm_per_px);
  look_from(0.5 * (a.x() + b.x()));
  const Vector3d normal = da.cross(db).normalized();
  frame_ << da, normal.cross(da), normal;
  for (std::size_t v = 0; v < views_.size(); ++v) {
    sights_in_corner_[v] = frame_.transpose() * sights_[v];
  }
  const Starts known_a(views_.size(), a.edge->length), known_b(views_.size(), b.edge->length);
  const double least_second = b.edge->length - tolerance;
  const auto [first, last] = index_.shapes_between(angle - options_.angle_tolerance_rad,
                                                   angle + options_.angle_tolerance_rad);
  for (std::size_t s = first; s < last; ++s) {
    const Range corners = index_.corners_between(s, a.edge->length - tolerance, kNever);
    if (corners.first == corners.second) continue;
    const CornerShape& shape = index_.shapes()[s];
    if (shape.longest.second < least_second) continue;
    if (!seen_by_all(shape.normals[0], *a.edge)) continue;
    if (!seen_by_all(shape.normals[1], *b.edge)) continue;
    ask(0, shape, Vector3d::UnitX(), shape.longest.first, known_a);
    ask(1, shape, {shape.cosine, shape.sine, 0}, shape.longest.second, known_b);
    compare(shape, corners, least_second);
  }
  offer_best();
}

}  // namespace trihedron
