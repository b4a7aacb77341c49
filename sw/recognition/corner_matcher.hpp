// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/evidence.hpp"
#include "recognition/hypotheses.hpp"
#include "recognition/index.hpp"
#include "recognition/pose_pool.hpp"
#include "recognition/spoke.hpp"

namespace trihedron {

/// A segment that leaves an end of a space edge, in some view.
struct Neighbour {
  int view;
  Plane plane;
  Eigen::Vector2d leaving;  ///< in the image
  bool through;             ///< it leaves to both sides
  double extent;            ///< px seen of it; a lower bound of its edge's length
};

/// A space edge as seen from one of its ends.
struct EdgeEnd {
  const SpaceEdge* edge;
  std::size_t end;

  const Eigen::Vector3d& x() const { return edge->end[end]; }
  Eigen::Vector3d leaving() const {
    return end == 0 ? edge->direction : Eigen::Vector3d(-edge->direction);
  }
};

/// Offers a pool the poses that put a corner of a model onto an observed one. Two edges make a
/// pose; what is seen along the rest of them and along a third edge must speak for it.
class CornerMatcher {
 public:
  CornerMatcher(const std::vector<ViewLines>& views, const Evidence& evidence,
                const LibraryIndex& index, const HypothesisOptions& options, PosePool& pool)
      : views_(views),
        evidence_(evidence),
        index_(index.corners()),
        options_(options),
        pool_(pool),
        least_evidence_(static_cast<float>(std::log(std::max<std::size_t>(1, index_.size())))) {}

  /// A whole edge, its length known, and a segment of one view that leaves its end.
  void match_whole(const EdgeEnd& whole, const Neighbour& neighbour);
  /// Two edges that share an end; their lengths are lower bounds.
  void match_corner(const EdgeEnd& a, const EdgeEnd& b);

 private:
  using Range = std::pair<std::size_t, std::size_t>;
  /// Per view: from which length on a spoke is asked.
  using Starts = std::vector<double>;

  void look_from(const Eigen::Vector3d& x);
  bool seen_by(const std::array<Eigen::Vector3d, 2>& normals, std::size_t view) const;
  bool seen_by_all(const std::array<Eigen::Vector3d, 2>& normals, const SpaceEdge& e) const;
  void ask(std::size_t edge, const CornerShape& shape, const Eigen::Vector3d& direction,
           double length, const Starts& known);
  void compare(const CornerShape& shape, const Range& corners, double least_second);
  void offer_best();

  const std::vector<ViewLines>& views_;
  const Evidence& evidence_;
  const CornerIndex& index_;
  const HypothesisOptions& options_;
  PosePool& pool_;
  float least_evidence_;  // for a corner's edges
  // What the corner in question is compared with.
  Eigen::Vector3d x_;                              // world
  Eigen::Matrix3d frame_;                          // world_from_corner, rotation
  std::vector<Eigen::Vector3d> sights_;            // per view: towards x, world
  std::vector<Eigen::Vector3d> sights_in_corner_;  // the same in the corner's frame
  std::array<Spoke, 3> spokes_;                    // along the corner's three edges
  Starts starts_, nothing_;
  /// A corner of a model, and what speaks for it.
  struct Candidate {
    float evidence;
    std::uint32_t frame;   // index into frames_
    std::uint32_t corner;  // of the index
  };
  std::vector<Eigen::Matrix3d> frames_;
  std::vector<Candidate> candidates_;
};

}  // namespace trihedron
