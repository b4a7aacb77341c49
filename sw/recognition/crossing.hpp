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

/// What one view contributes to the crossing: all of it in the undistorted image.
struct ViewLines {
  IdealView ideal;
  int width = 0, height = 0;  ///< px
  std::vector<Segment> segments;
  std::vector<Plane> planes;  ///< per segment: the points that project on it
  std::vector<Corner> corners;
  std::vector<std::array<Eigen::Vector2d, 2>> ends;  ///< per segment: p0 and p1, moved to a corner
                                                     ///< where one is near
  std::vector<std::array<std::vector<int>, 2>> end_corners;  ///< per segment and end: its corners
};

/// Segments and corners of one view.
ViewLines find_lines(const View& view);

/// Two segments of different views that may show the same edge of an object.
struct SpaceEdge {
  std::array<int, 2> view{};                   ///< indices, ascending
  std::array<int, 2> segment{};                ///< per view
  std::array<Eigen::Vector3d, 2> end;          ///< ends in the world, mm: of the longer reach
  Eigen::Vector3d direction;                   ///< unit, end[0] -> end[1]
  double length = 0;                           ///< mm; a lower bound unless both ends are agreed
  std::array<bool, 2> agreed{};                ///< both views see the edge end here
  std::array<std::array<int, 2>, 2> end_of{};  ///< per view: which of its segment's ends is end[k]
  int confirmations = 0;                       ///< further views that show a segment there
  double sigma = 0;                            ///< of an end along the edge, mm
};

struct CrossingOptions {
  double end_tolerance_px = 4;        ///< ends of segments: rounding by the 5x5 masks in both views
  double min_plane_angle_rad = 0.14;  ///< interpretation planes closer to parallel give no line
  double min_overlap = 0.5;           ///< of the shorter piece
};

/// All candidates, most confirmed first, longer ones first among equals.
std::vector<SpaceEdge> cross_edges(const std::vector<ViewLines>& views,
                                   const CrossingOptions& options = {});

}  // namespace trihedron
