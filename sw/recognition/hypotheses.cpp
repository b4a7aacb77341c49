// SPDX-License-Identifier: Apache-2.0
#include "recognition/hypotheses.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/corner_matcher.hpp"
#include "recognition/edge_pairs.hpp"
#include "recognition/evidence.hpp"
#include "recognition/pose_pool.hpp"

namespace trihedron {
namespace {

using Eigen::Vector2d;

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

class Search {
 public:
  Search(const std::vector<ViewLines>& views, const std::vector<SpaceEdge>& edges,
         const HypothesisOptions& options, CornerMatcher& matcher)
      : views_(views), edges_(edges), options_(options), matcher_(matcher) {}

  /// Poses from edges whose both ends two views agree on; of the flat ones or of the others.
  /// Edges whose segments are all claimed (per view and segment) are left out.
  void from_whole_edges(bool flat, const Claims& claimed) {
    for (const SpaceEdge& e : edges_) {
      if (e.flat != flat || !e.agreed[0] || !e.agreed[1] || all_claimed(e, claimed)) continue;
      for (const std::size_t end : {0U, 1U}) {
        for (const Neighbour& n : neighbours(views_, e, end)) matcher_.match_whole({&e, end}, n);
      }
    }
  }

  /// Poses from pairs of edges that share an agreed end; their lengths are lower bounds. Corners
  /// whose segments are both claimed (per view and segment) are left out.
  void from_corners(const Claims& claimed) {
    for (std::size_t v = 0; v < views_.size(); ++v) {
      const std::vector<std::vector<EdgeEnd>> ends = ends_by_segment(v);
      for (const Corner& c : views_[v].corners) {
        const auto s0 = static_cast<std::size_t>(c.segment[0]);
        const auto s1 = static_cast<std::size_t>(c.segment[1]);
        if (claimed[v][s0] && claimed[v][s1]) continue;
        for (const EdgeEnd& a : ends[s0]) {
          for (const EdgeEnd& b : ends[s1]) {
            if (!meet(a, b, v, c.p)) continue;
            matcher_.match_corner(a, b);
            matcher_.match_corner(b, a);
          }
        }
      }
    }
  }

 private:
  /// Per segment of a view: the agreed ends of the edges that it shows.
  std::vector<std::vector<EdgeEnd>> ends_by_segment(std::size_t view) const {
    std::vector<std::vector<EdgeEnd>> out(views_[view].segments.size());
    for (const SpaceEdge& e : edges_) {
      if (e.segment[view] < 0 || e.flat) continue;
      for (const std::size_t k : {0U, 1U}) {
        if (e.agreed[k]) out[static_cast<std::size_t>(e.segment[view])].push_back({&e, k});
      }
    }
    return out;
  }

  /// Whether two edges end in one point that the view sees at p.
  bool meet(const EdgeEnd& a, const EdgeEnd& b, std::size_t view, const Vector2d& p) const {
    const double limit =
        options_.length_tolerance_px * std::max(a.edge->mm_per_px, b.edge->mm_per_px);
    if ((a.x() - b.x()).squaredNorm() > limit * limit) return false;
    constexpr double kReachPx = 4;
    const Vector2d q = views_[view].ideal.project(0.5 * (a.x() + b.x()));
    return (q - p).squaredNorm() < kReachPx * kReachPx;
  }

  const std::vector<ViewLines>& views_;
  const std::vector<SpaceEdge>& edges_;
  const HypothesisOptions& options_;
  CornerMatcher& matcher_;
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
  CornerMatcher matcher(views, evidence, index, options, pool);
  Search search(views, edges, options, matcher);
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
