// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recognition/segments.hpp"

namespace trihedron {

/// Two segments of a view that meet: where, and which ways they leave.
struct Corner {
  Eigen::Vector2d p;                       ///< intersection of the two lines, undistorted px
  double sigma = 0;                        ///< px, the worse direction
  std::array<int, 2> segment{};            ///< indices, the longer first
  std::array<Eigen::Vector2d, 2> leaving;  ///< unit, from p along the segments
  /// The segment runs on through p (a T-junction, often an occluding edge): `leaving` may as well
  /// be its opposite.
  std::array<bool, 2> through{};
};

struct CornerOptions {
  double reach_px = 5;         ///< from a segment's end to p: half of the 5x5 masks and rounding
  double min_angle_rad = 0.2;  ///< below, the intersection is too uncertain
  int max_corners = 300;       ///< the ones with the longest segments are kept
};

/// The corners of a view, those with longer segments first.
std::vector<Corner> find_corners(const std::vector<Segment>& segments,
                                 const CornerOptions& options = {});

}  // namespace trihedron
