// SPDX-License-Identifier: Apache-2.0
#include "recognition/hypotheses.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recognition/edge_pairs.hpp"
#include "recognition/evidence.hpp"
#include "recognition/pose_pool.hpp"

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A segment that leaves an end of a space edge, in some view.
struct Neighbour {
  int view;
  Plane plane;
  Vector2d leaving;  ///< in the image
  bool through;      ///< it leaves to both sides
  double extent;     ///< px seen of it; a lower bound of its edge's length
};

/// The segments of all views that meet where an edge ends, but for those along the edge.
std::vector<Neighbour> neighbours(const std::vector<ViewLines>& views, const SpaceEdge& e,
                                  std::size_t end) {
  constexpr double kReachPx = 4;       // between a corner and the projected end
  constexpr double kAcrossCos = 0.97;  // of the angle to the edge: below 14 degrees it is the edge
  std::vector<Neighbour> out;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ViewLines& v = views[i];
    const Vector2d p = v.ideal.project(e.end[end]);
    const Vector2d along = (v.ideal.project(e.end[1 - end]) - p).normalized();
    std::vector<int> seen;
    for (const Corner& corner : v.corners) {
      if ((corner.p - p).squaredNorm() > kReachPx * kReachPx) continue;
      for (const std::size_t k : {0U, 1U}) {
        const int s = corner.segment[k];
        if (std::abs(corner.leaving[k].dot(along)) > kAcrossCos) continue;
        if (std::find(seen.begin(), seen.end(), s) != seen.end()) continue;
        seen.push_back(s);
        const Segment& segment = v.segments[static_cast<std::size_t>(s)];
        const double extent = std::max(corner.leaving[k].dot(segment.p0 - corner.p),
                                       corner.leaving[k].dot(segment.p1 - corner.p));
        out.push_back({static_cast<int>(i), v.planes[static_cast<std::size_t>(s)],
                       corner.leaving[k], corner.through[k], extent});
      }
    }
  }
  return out;
}

/// Rotations that turn a corner's first edge onto a direction and its second one into a plane: what
/// all corners share of them. Thousands of corners are tried on one direction and plane, so no
/// trigonometric function is called for any of them.
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

  /// Calls the visitor with each rotation and where the second edge comes to lie.
  template <typename Visitor>
  void of(const ModelCorner& c, Visitor&& visitor) const {
    const double cosine = c.along.dot(c.aside), sine = std::sqrt(1 - cosine * cosine);
    const double q = -cosine / sine * lean_;
    constexpr double kGrazing = 1.02;  // a plane that the second edge misses by a few degrees
    if (!possible_ || !(std::abs(q) <= kGrazing)) return;
    // Roll angles middle +- half, by their cosines and sines.
    const double cos_half = std::clamp(q, -1.0, 1.0), sin_half = std::sqrt(1 - cos_half * cos_half);
    const Vector3d model_u = (c.aside - cosine * c.along) / sine;
    Matrix3d model_frame, frame;
    model_frame << c.along, model_u, c.along.cross(model_u);
    for (const double s : {sin_half, -sin_half}) {
      const Vector3d side = (middle_.x() * cos_half - middle_.y() * s) * u_ +
                            (middle_.y() * cos_half + middle_.x() * s) * w_;
      frame << direction_, side, direction_.cross(side);
      visitor(Matrix3d(frame * model_frame.transpose()),
              Vector3d(cosine * direction_ + sine * side));
    }
  }

 private:
  Vector3d direction_, u_, w_;  ///< right-handed
  bool possible_;
  Vector2d middle_;  ///< cosine and sine of the roll at which the plane's normal points sideways
  double lean_ = 0;  ///< of the direction out of the plane
};

class Search {
 public:
  Search(const std::vector<ViewLines>& views, const std::vector<SpaceEdge>& edges,
         const LibraryIndex& index, const HypothesisOptions& options, PosePool& pool)
      : views_(views), edges_(edges), index_(index), options_(options), pool_(pool) {}

  /// Poses from edges whose both ends two views agree on; of the flat ones or of the others.
  /// Edges whose segments are all claimed (per view and segment) are left out.
  void from_whole_edges(bool flat, const Claims& claimed) {
    for (const SpaceEdge& e : edges_) {
      if (e.flat != flat || !e.agreed[0] || !e.agreed[1] || all_claimed(e, claimed)) continue;
      for (const std::size_t end : {0U, 1U}) {
        for (const Neighbour& n : neighbours(views_, e, end)) match_whole(e, end, n);
      }
    }
  }

  /// Poses from pairs of edges that share an agreed end; their lengths are lower bounds. Corners
  /// whose segments are both claimed (per view and segment) are left out.
  void from_corners(const Claims& claimed) {
    for (std::size_t v = 0; v < views_.size(); ++v) {
      const std::vector<std::vector<End>> ends = ends_by_segment(v);
      for (const Corner& c : views_[v].corners) {
        const auto s0 = static_cast<std::size_t>(c.segment[0]);
        const auto s1 = static_cast<std::size_t>(c.segment[1]);
        if (claimed[v][s0] && claimed[v][s1]) continue;
        for (const End& a : ends[s0]) {
          for (const End& b : ends[s1]) {
            if (!meet(a, b, v, c.p)) continue;
            match_corner(a, b);
            match_corner(b, a);
          }
        }
      }
    }
  }

 private:
  struct End {
    const SpaceEdge* edge;
    std::size_t end;

    const Vector3d& x() const { return edge->end[end]; }
    Vector3d leaving() const { return end == 0 ? edge->direction : Vector3d(-edge->direction); }
  };

  /// Per segment of a view: the agreed ends of the edges that it shows.
  std::vector<std::vector<End>> ends_by_segment(std::size_t view) const {
    std::vector<std::vector<End>> out(views_[view].segments.size());
    for (const SpaceEdge& e : edges_) {
      if (e.segment[view] < 0 || e.flat) continue;
      for (const std::size_t k : {0U, 1U}) {
        if (e.agreed[k]) out[static_cast<std::size_t>(e.segment[view])].push_back({&e, k});
      }
    }
    return out;
  }

  /// Whether two edges end in one point that the view sees at p.
  bool meet(const End& a, const End& b, std::size_t view, const Vector2d& p) const {
    const double limit =
        options_.length_tolerance_px * std::max(a.edge->mm_per_px, b.edge->mm_per_px);
    if ((a.x() - b.x()).squaredNorm() > limit * limit) return false;
    constexpr double kReachPx = 4;
    const Vector2d q = views_[view].ideal.project(0.5 * (a.x() + b.x()));
    return (q - p).squaredNorm() < kReachPx * kReachPx;
  }

  /// Whether one of the surfaces at an edge at x turns to the view.
  bool visible(const std::array<Vector3d, 2>& normals, const Matrix3d& R, const Vector3d& x,
               std::size_t view) const {
    const Vector3d sight = R.transpose() * views_[view].ideal.sight(x);
    return normals[0].dot(sight) < 0 || normals[1].dot(sight) < 0;
  }

  /// Whether an edge could be seen by all views that show it.
  bool visible(const std::array<Vector3d, 2>& normals, const Matrix3d& R, const SpaceEdge& e,
               const Vector3d& x) const {
    for (std::size_t v = 0; v < views_.size(); ++v) {
      if (e.segment[v] >= 0 && !visible(normals, R, x, v)) return false;
    }
    return true;
  }

  void match_whole(const SpaceEdge& e, std::size_t end, const Neighbour& n) {
    const Vector3d& x = e.end[end];
    const Vector3d direction = end == 0 ? e.direction : Vector3d(-e.direction);
    const IdealView& view = views_[static_cast<std::size_t>(n.view)].ideal;
    const Vector2d p = view.project(x);
    const double tolerance = options_.length_tolerance_px * e.end_mm_per_px;
    const Rotations rotations(direction, n.plane.normal);
    for (const ModelCorner& c : index_.by_length(e.length - tolerance, e.length + tolerance)) {
      rotations.of(c, [&](const Matrix3d& R, const Vector3d& aside) {
        if (!n.through) {
          const Vector2d seen = view.project(x + c.aside_length * aside) - p;
          if (seen.dot(n.leaving) < n.extent - options_.length_tolerance_px) return;
        }
        if (!visible(c.aside_normals, R, x, static_cast<std::size_t>(n.view))) return;
        if (visible(c.along_normals, R, e, x)) pool_.add(c.model, {R, x - R * c.position});
      });
    }
  }

  void match_corner(const End& a, const End& b) {
    const Vector3d da = a.leaving(), db = b.leaving();
    const double angle = std::acos(std::clamp(da.dot(db), -1.0, 1.0));
    constexpr double kMinSine = 0.2;  // else the normal is too uncertain
    if (std::sin(angle) < kMinSine) return;
    const double tolerance =
        options_.length_tolerance_px * std::max(a.edge->mm_per_px, b.edge->mm_per_px);
    const Vector3d x = 0.5 * (a.x() + b.x());
    Matrix3d frame, model_frame;
    const Vector3d normal = da.cross(db).normalized();
    frame << da, normal.cross(da), normal;
    for (const ModelCorner& c : index_.by_angle(angle - options_.angle_tolerance_rad,
                                                angle + options_.angle_tolerance_rad)) {
      if (c.length < a.edge->length - tolerance) continue;
      if (c.aside_length < b.edge->length - tolerance) continue;
      const Vector3d n = c.along.cross(c.aside).normalized();
      model_frame << c.along, n.cross(c.along), n;
      const Matrix3d R = frame * model_frame.transpose();
      if (!visible(c.along_normals, R, *a.edge, x)) continue;
      if (!visible(c.aside_normals, R, *b.edge, x)) continue;
      pool_.add(c.model, {R, x - R * c.position});
    }
  }

  const std::vector<ViewLines>& views_;
  const std::vector<SpaceEdge>& edges_;
  const LibraryIndex& index_;
  const HypothesisOptions& options_;
  PosePool& pool_;
};

}  // namespace

std::vector<PoseHypothesis> find_hypotheses(const std::vector<ViewLines>& views,
                                            const std::vector<SpaceEdge>& edges,
                                            const std::vector<Model>& library,
                                            const LibraryIndex& index,
                                            const HypothesisOptions& options,
                                            HypothesisStatistics* statistics) {
  const Evidence evidence(views);
  PosePool pool(evidence, library, index, options);
  Search search(views, edges, index, options, pool);
  Claims claimed;
  for (const ViewLines& v : views) claimed.emplace_back(v.segments.size(), 0);
  search.from_whole_edges(false, claimed);
  // Whole edges find most objects at little cost; the rest is searched for what is left.
  for (const PoseHypothesis& h : pool.settle()) {
    evidence.claim(index.sketch(h.model), h.world_from_model, options.claim_share, claimed);
  }
  search.from_whole_edges(true, claimed);
  poses_from_edge_pairs(views, edges, library, index, options, claimed, pool);
  search.from_corners(claimed);
  const std::vector<PoseHypothesis> out = pool.settle();
  if (statistics != nullptr) {
    *statistics = {pool.offered(), pool.scored(), static_cast<int>(out.size())};
  }
  return out;
}

}  // namespace trihedron
