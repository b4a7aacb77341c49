// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "recognition/crossing.hpp"

namespace trihedron {
namespace {

/// Where a corner lies on one of its segments: at an end (0: p0, 1: p1) or, -1, between them.
int end_at(const Corner& c, std::size_t k, const Segment& s) {
  if (c.through[k]) return -1;
  return s.along(c.p) < 0.5 * s.length ? 0 : 1;
}

/// The ends of a segment, moved to the nearest corners, and the corners between them.
std::vector<Stop> stops_of(const ViewLines& v, int segment) {
  const Segment& s = v.segments[static_cast<std::size_t>(segment)];
  Eigen::Vector2d end[2] = {s.p0, s.p1};
  double nearest[2] = {1e9, 1e9};
  bool corner[2] = {false, false};
  std::vector<Stop> out(2);
  for (const Corner& c : v.corners) {
    for (const std::size_t k : {0U, 1U}) {
      if (c.segment[k] != segment) continue;
      const int at = end_at(c, k, s);
      if (at < 0) {
        out.push_back({v.ideal.ray(c.p), false, false});
        continue;
      }
      corner[at] = corner[at] || !c.through[1 - k];
      const double d = (c.p - (at == 0 ? s.p0 : s.p1)).norm();
      if (d < nearest[at]) {
        nearest[at] = d;
        end[at] = c.p;
      }
    }
  }
  out[0] = {v.ideal.ray(end[0]), true, corner[0]};
  out[1] = {v.ideal.ray(end[1]), true, corner[1]};
  return out;
}

}  // namespace

ViewLines find_lines(const View& view) { return find_lines(view, find_edgels(view.features)); }

ViewLines find_lines(const View& view, const EdgelMap& edgels) {
  return lines_of_segments(IdealView(view.camera), view.features.width, view.features.height,
                           find_segments(edgels, view.camera));
}

ViewLines lines_of_segments(const IdealView& ideal, int width, int height,
                            std::vector<Segment> segments) {
  ViewLines v{ideal, width, height, std::move(segments), {}, {}, {}};
  v.corners = find_corners(v.segments);
  for (int s = 0; s < static_cast<int>(v.segments.size()); ++s) {
    const Segment& segment = v.segments[static_cast<std::size_t>(s)];
    v.planes.push_back(v.ideal.plane(segment.p0, segment.p1));
    v.stops.push_back(stops_of(v, s));
  }
  return v;
}

}  // namespace trihedron
