// SPDX-License-Identifier: Apache-2.0
#include "recognition/corners.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// How a segment stands to a point of its line.
struct Standing {
  bool near = false, through = false;
  Vector2d leaving = Vector2d::Zero();
};

Standing standing(const Segment& s, const Vector2d& p, double reach) {
  const double t = s.along(p);
  Standing out;
  out.near = t > -reach && t < s.length + reach;
  out.leaving = t < 0.5 * s.length ? s.direction : Vector2d(-s.direction);
  // Short segments end near any of their points; they never run through.
  out.through = t > reach && t < s.length - reach;
  return out;
}

}  // namespace

std::vector<Corner> find_corners(const std::vector<Segment>& segments,
                                 const CornerOptions& options) {
  std::vector<Corner> corners;
  const double min_sine = std::sin(options.min_angle_rad);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const Segment &a = segments[i], &b = segments[j];
      const double sine = cross(a.direction, b.direction);
      if (std::abs(sine) < min_sine) continue;
      const Vector2d p = a.p0 + cross(b.p0 - a.p0, b.direction) / sine * a.direction;
      const Standing sa = standing(a, p, options.reach_px), sb = standing(b, p, options.reach_px);
      if (!sa.near || !sb.near || (sa.through && sb.through)) continue;
      Corner c;
      c.p = p;
      c.segment = {static_cast<int>(i), static_cast<int>(j)};
      c.leaving = {sa.leaving, sb.leaving};
      c.through = {sa.through, sb.through};
      // Each line is uncertain across itself; at its end twice as much as in its middle.
      c.sigma = 2 * std::hypot(a.offset_sigma, b.offset_sigma) / std::abs(sine);
      corners.push_back(c);
    }
  }
  const auto shorter = [&](const Corner& c) {
    return segments[static_cast<std::size_t>(c.segment[1])].length;
  };
  std::stable_sort(corners.begin(), corners.end(),
                   [&](const Corner& a, const Corner& b) { return shorter(a) > shorter(b); });
  if (corners.size() > static_cast<std::size_t>(options.max_corners)) {
    corners.resize(static_cast<std::size_t>(options.max_corners));
  }
  return corners;
}

}  // namespace trihedron
