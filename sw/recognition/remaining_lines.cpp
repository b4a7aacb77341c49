// SPDX-License-Identifier: Apache-2.0
#include "recognition/remaining_lines.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// A predicted edge in the undistorted image, px.
struct Line {
  Eigen::Vector2d p0, p1;
};

/// The part of a segment that runs along a line, px.
double overlap_px(const Segment& s, const Line& line) {
  constexpr double kWithinPx = 3;  // as contours belong to predicted lines
  const double t0 = s.along(line.p0), t1 = s.along(line.p1);
  const double low = std::max(0.0, std::min(t0, t1)), high = std::min(s.length, std::max(t0, t1));
  if (high <= low || std::abs(t1 - t0) < 1e-9) return 0;
  const double d0 = s.distance(line.p0), slope = (s.distance(line.p1) - d0) / (t1 - t0);
  const auto distance = [&](double t) { return std::abs(d0 + slope * (t - t0)); };
  return distance(low) < kWithinPx && distance(high) < kWithinPx ? high - low : 0;
}

}  // namespace

ViewLines remaining_lines(const ViewLines& lines, const Camera& camera,
                          const std::vector<PlacedModel>& known) {
  constexpr double kExplained = 0.5;  // of a segment's length
  std::vector<Line> predicted;
  for (const VisibleEdge& e : visible_edges(camera, known)) {
    predicted.push_back({lines.ideal.project(e.x0_in_world), lines.ideal.project(e.x1_in_world)});
  }
  std::vector<Segment> rest;
  for (const Segment& s : lines.segments) {
    double explained = 0;
    for (const Line& line : predicted) explained += overlap_px(s, line);
    if (explained < kExplained * s.length) rest.push_back(s);
  }
  return lines_of_segments(lines.ideal, lines.width, lines.height, std::move(rest));
}

}  // namespace trihedron
