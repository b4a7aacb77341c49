// SPDX-License-Identifier: Apache-2.0
#include "recognition/hypotheses.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recognition/evidence.hpp"

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A segment of some view that leaves an end of a space edge.
struct Neighbour {
  const ViewLines* view;
  Plane plane;
  Vector2d leaving;  ///< in the image
  bool through;
};

/// The segments of all views that meet where an edge ends, but for those along the edge.
std::vector<Neighbour> neighbours(const std::vector<ViewLines>& views, const SpaceEdge& e,
                                  std::size_t end) {
  constexpr double kReachPx = 4;       // between a corner and the projected end
  constexpr double kAcrossCos = 0.97;  // of the angle to the edge: below 14 degrees it is the edge
  std::vector<Neighbour> out;
  for (const ViewLines& v : views) {
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
        out.push_back(
            {&v, v.planes[static_cast<std::size_t>(s)], corner.leaving[k], corner.through[k]});
      }
    }
  }
  return out;
}

/// Rotations that turn `along` onto `direction` and `aside` into the neighbour's plane, on the
/// side where the neighbour leaves the corner (seen at x).
template <typename Visitor>
void rotations(const ModelCorner& c, const Vector3d& x, const Vector3d& direction,
               const Neighbour& n, Visitor&& visitor) {
  const Vector3d u = direction.unitOrthogonal(), w = direction.cross(u);
  const double sine = std::sin(c.angle), cosine = std::cos(c.angle);
  const double a = n.plane.normal.dot(u), b = n.plane.normal.dot(w);
  const double rho = std::hypot(a, b);
  if (rho < 0.05) return;
  double q = -cosine / sine * n.plane.normal.dot(direction) / rho;
  constexpr double kGrazing = 1.02;  // a plane that the second edge misses by a few degrees
  if (std::abs(q) > kGrazing) return;
  q = std::clamp(q, -1.0, 1.0);
  const double middle = std::atan2(b, a), half = std::acos(q);
  const Vector3d model_u = (c.aside - cosine * c.along) / sine;
  Matrix3d model_frame, frame;
  model_frame << c.along, model_u, c.along.cross(model_u);
  for (const double phi : {middle + half, middle - half}) {
    const Vector3d side = std::cos(phi) * u + std::sin(phi) * w;
    const Vector3d second = cosine * direction + sine * side;
    const Vector2d seen = n.view->ideal.project(x + second) - n.view->ideal.project(x);
    if (!n.through && seen.dot(n.leaving) <= 0) continue;
    frame << direction, side, direction.cross(side);
    visitor(Matrix3d(frame * model_frame.transpose()));
  }
}

class Search {
 public:
  Search(const std::vector<ViewLines>& views, const std::vector<Model>& library,
         const LibraryIndex& index, const HypothesisOptions& options)
      : views_(views), library_(library), index_(index), options_(options), evidence_(views) {}

  /// Poses from edges whose both ends two views agree on.
  void from_whole_edges(const std::vector<SpaceEdge>& edges) {
    for (const SpaceEdge& e : edges) {
      if (!e.agreed[0] || !e.agreed[1]) continue;
      const double tolerance = options_.length_tolerance_px * e.mm_per_px;
      for (const std::size_t end : {0U, 1U}) {
        const Vector3d direction = end == 0 ? e.direction : Vector3d(-e.direction);
        for (const Neighbour& n : neighbours(views_, e, end)) {
          for (const ModelCorner& c :
               index_.by_length(e.length - tolerance, e.length + tolerance)) {
            rotations(c, e.end[end], direction, n,
                      [&](const Matrix3d& R) { add(c.model, R, e.end[end] - R * c.position); });
          }
        }
      }
    }
  }

  /// Poses from pairs of edges that share an agreed end; their lengths are lower bounds.
  void from_corners(const std::vector<SpaceEdge>& edges) {
    struct End {
      const SpaceEdge* edge;
      std::size_t end;
    };
    std::vector<End> ends;
    for (const SpaceEdge& e : edges) {
      for (const std::size_t k : {0U, 1U}) {
        if (e.agreed[k]) ends.push_back({&e, k});
      }
    }
    for (const End& a : ends) {
      for (const End& b : ends) {
        if (a.edge == b.edge) continue;
        const double tolerance =
            options_.length_tolerance_px * std::max(a.edge->mm_per_px, b.edge->mm_per_px);
        if ((a.edge->end[a.end] - b.edge->end[b.end]).squaredNorm() > tolerance * tolerance) {
          continue;
        }
        match_corner(*a.edge, a.end, *b.edge, b.end, tolerance);
      }
    }
  }

  std::vector<PoseHypothesis> finish(HypothesisStatistics* statistics);

 private:
  void match_corner(const SpaceEdge& a, std::size_t end_a, const SpaceEdge& b, std::size_t end_b,
                    double tolerance) {
    const Vector3d da = end_a == 0 ? a.direction : Vector3d(-a.direction);
    const Vector3d db = end_b == 0 ? b.direction : Vector3d(-b.direction);
    const double angle = std::acos(std::clamp(da.dot(db), -1.0, 1.0));
    if (std::sin(angle) < 0.2) return;
    const Vector3d x = 0.5 * (a.end[end_a] + b.end[end_b]);
    Matrix3d frame, model_frame;
    const Vector3d normal = da.cross(db).normalized();
    frame << da, normal.cross(da), normal;
    for (const ModelCorner& c : index_.by_angle(angle - options_.angle_tolerance_rad,
                                                angle + options_.angle_tolerance_rad)) {
      if (c.length < a.length - tolerance || c.aside_length < b.length - tolerance) continue;
      const Vector3d n = c.along.cross(c.aside).normalized();
      model_frame << c.along, n.cross(c.along), n;
      const Matrix3d R = frame * model_frame.transpose();
      add(c.model, R, x - R * c.position);
    }
  }

  void add(int model, const Matrix3d& R, const Vector3d& t) {
    PoseHypothesis h{model, {R, t}, 0};
    h.support = evidence_.score(library_[static_cast<std::size_t>(model)], h.world_from_model, 2);
    ++poses_;
    if (h.support > 0) found_.push_back(h);
  }

  /// Same pose up to a symmetry: vertices closer than a tenth of the diameter.
  bool same(const PoseHypothesis& a, const PoseHypothesis& b) const {
    const Model& m = library_[static_cast<std::size_t>(a.model)];
    const double limit = 0.04 * m.diameter;
    const auto close = [&](const Transform& pose) {
      for (const Vector3d& x : m.mesh.vertices) {
        if ((pose * x - b.world_from_model * x).squaredNorm() > limit * limit) return false;
      }
      return true;
    };
    if (close(a.world_from_model)) return true;
    return std::any_of(m.symmetries.begin(), m.symmetries.end(),
                       [&](const Transform& s) { return close(a.world_from_model * s); });
  }

  const std::vector<ViewLines>& views_;
  const std::vector<Model>& library_;
  const LibraryIndex& index_;
  const HypothesisOptions& options_;
  Evidence evidence_;
  std::vector<PoseHypothesis> found_;
  int poses_ = 0;
};

void keep_best(std::vector<PoseHypothesis>& h, int count) {
  std::stable_sort(h.begin(), h.end(), [](const PoseHypothesis& a, const PoseHypothesis& b) {
    return a.support > b.support;
  });
  if (h.size() > static_cast<std::size_t>(count)) h.resize(static_cast<std::size_t>(count));
}

std::vector<PoseHypothesis> Search::finish(HypothesisStatistics* statistics) {
  keep_best(found_, options_.max_coarse);
  for (PoseHypothesis& h : found_) {
    const Model& m = library_[static_cast<std::size_t>(h.model)];
    for (int k = 0; k < 2; ++k) evidence_.refine(m, h.world_from_model);
    h.support = evidence_.score(m, h.world_from_model, 8);
  }
  keep_best(found_, options_.max_coarse);
  std::vector<PoseHypothesis> out;
  for (const PoseHypothesis& h : found_) {
    if (out.size() == static_cast<std::size_t>(options_.max_hypotheses)) break;
    const bool known = std::any_of(out.begin(), out.end(), [&](const PoseHypothesis& other) {
      return other.model == h.model && same(h, other);
    });
    if (!known) out.push_back(h);
  }
  if (statistics != nullptr) *statistics = {poses_, static_cast<int>(out.size())};
  return out;
}

}  // namespace

std::vector<PoseHypothesis> find_hypotheses(const std::vector<ViewLines>& views,
                                            const std::vector<SpaceEdge>& edges,
                                            const std::vector<Model>& library,
                                            const LibraryIndex& index,
                                            const HypothesisOptions& options,
                                            HypothesisStatistics* statistics) {
  Search search(views, library, index, options);
  search.from_whole_edges(edges);
  search.from_corners(edges);
  return search.finish(statistics);
}

}  // namespace trihedron
