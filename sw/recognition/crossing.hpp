// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recognition/corners.hpp"
#include "recognition/ideal_view.hpp"
#include "recognition/recognize.hpp"
#include "recognition/segments.hpp"

namespace trihedron {

/// A place along a segment where an edge may end: an end of the segment or a corner on it.
struct Stop {
  Ray ray;              ///< of the points that project onto it
  bool end = true;      ///< false: the segment runs on
  bool corner = false;  ///< an end where another segment ends, too: not one that something hides
};

/// What one view contributes to the crossing: all of it in the undistorted image.
struct ViewLines {
  IdealView ideal;
  int width = 0, height = 0;  ///< px
  std::vector<Segment> segments;
  std::vector<Corner> corners;
  std::vector<Plane> planes;             ///< per segment: the points that project onto it
  std::vector<std::vector<Stop>> stops;  ///< per segment: first its two ends (p0, p1), moved to a
                                         ///< corner where one is near
};

/// Segments and corners of one view.
ViewLines find_lines(const View& view);
/// The same from the view's edge points.
ViewLines find_lines(const View& view, const EdgelMap& edgels);
/// The corners, planes and stops of given segments, longest first.
ViewLines lines_of_segments(const IdealView& ideal, int width, int height,
                            std::vector<Segment> segments);

/// Segments of two views or more that may show the same edge of an object.
struct SpaceEdge {
  std::vector<int> segment;            ///< per view: index of its segment, -1: shows none
  std::array<Eigen::Vector3d, 2> end;  ///< world, mm
  std::array<bool, 2> agreed{};        ///< two views see the edge end here; one end at least
  Eigen::Vector3d direction;           ///< unit, end[0] -> end[1]
  double length = 0;                   ///< mm; a lower bound unless both ends are agreed
  double mm_per_px = 0;                ///< along the edge, in the crossed view that sees it worse
  double end_mm_per_px = 0;            ///< the same for an end measured by both views together
  bool flat = false;  ///< the views look along one plane: only the rays of the ends speak for it
  int confirmations = 0;  ///< views beyond two that show it
};

struct CrossingOptions {
  double end_tolerance_px = 4;  ///< of the ends of segments: half of the 5x5 masks and noise
  /// An edge also ends where one view sees it end in a corner while the other, where something may
  /// hide it, does not see it reach so far.
  bool one_view_ends = false;
  double min_plane_angle_rad = 0.14;  ///< planes of sight closer to parallel give no line
};

/// All candidates, most confirmed first, longer ones first among equals.
std::vector<SpaceEdge> cross_edges(const std::vector<ViewLines>& views,
                                   const CrossingOptions& options = {});

}  // namespace trihedron
