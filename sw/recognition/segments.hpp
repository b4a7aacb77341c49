// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/camera.hpp"
#include "recognition/edgels.hpp"

namespace trihedron {

/// A straight piece of contour in one view, in the undistorted image (px): where an ideal camera
/// with the same K sees it.
struct Segment {
  Eigen::Vector2d p0, p1;     ///< ends; walking p0 -> p1, the bright side lies to the right
  Eigen::Vector2d direction;  ///< unit, p0 -> p1
  Eigen::Vector2d normal;     ///< unit, towards the bright side
  double length = 0;          ///< px
  double offset_sigma = 0;    ///< of the line across itself at its middle, px
  double angle_sigma = 0;     ///< of its direction, rad
  double strength = 0;        ///< mean gradient in units of its noise
  int support = 0;            ///< edge points on it

  Eigen::Vector2d middle() const { return 0.5 * (p0 + p1); }
  /// Signed distance of a point from the line, px, positive on the bright side.
  double distance(const Eigen::Vector2d& p) const { return normal.dot(p - p0); }
  /// Position of a point along the line from p0, px.
  double along(const Eigen::Vector2d& p) const { return direction.dot(p - p0); }
};

struct SegmentOptions {
  /// A segment starts at a point this strong (sigmas of the noise): chance reaches it in 3 pixels
  /// of 10000, while a weak line has many points and one of them passes.
  float min_seed_strength = 4;
  double max_distance_px = 0.8;  ///< of an edge point from its line: pixel grid plus noise
  double min_cosine = 0.8;       ///< between an edge point's gradient and the line's normal
  int max_gap_px = 4;            ///< steps without an edge point that are bridged
  double min_length_px = 6;      ///< shorter pieces have no usable direction
  /// Smallest sum of strengths: what chance ridges (2.5 sigma each) reach only on a straight
  /// run of 16, which noise does not produce in a megapixel.
  double min_evidence = 40;
};

/// Straight segments of a view, longest first: grown from the strongest edge points along their
/// tangents, bridging gaps, ended at bends, fitted by total least squares weighted by strength.
std::vector<Segment> find_segments(const EdgelMap& edgels, const Camera& camera,
                                   const SegmentOptions& options = {});

}  // namespace trihedron
