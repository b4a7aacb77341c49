// SPDX-License-Identifier: Apache-2.0
#include "recognition/region_boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace trihedron {
namespace {

/// Directions on the screen, each the previous one turned left: right, up, left, down.
enum Direction { kRight, kUp, kLeft, kDown };
constexpr std::array<int, 4> kStepX = {1, 0, -1, 0};
constexpr std::array<int, 4> kStepY = {0, -1, 0, 1};

Direction turned_left(Direction d) { return static_cast<Direction>((d + 1) % 4); }
Direction turned_right(Direction d) { return static_cast<Direction>((d + 3) % 4); }

/// A crack: the side of pixel (x, y) that lies to the right of someone who walks in direction
/// `heading` with the pixel to the left. Walking on like this goes counter-clockwise around the
/// region and clockwise around its holes.
struct Crack {
  int x, y;
  Direction heading;
  bool operator==(const Crack& o) const { return x == o.x && y == o.y && heading == o.heading; }
};

class LoopTracer {
 public:
  LoopTracer(const RegionMap& map, const ViewFeatures& features)
      : map_(map), features_(features), visited_(map.labels.size(), 0) {}

  bool open(const Crack& c) const {
    const int label = map_.at(c.x, c.y);
    const Direction out = turned_right(c.heading);
    return label > 0 && !is(label, c.x + kStepX[out], c.y + kStepY[out]) &&
           (visited_[index(c)] & (1u << c.heading)) == 0;
  }

  BoundaryLoop trace(const Crack& start) {
    BoundaryLoop loop;
    int last_x = -2, last_y = -2;
    double twice_area = 0;
    Crack c = start;
    do {
      visited_[index(c)] |= static_cast<std::uint8_t>(1u << c.heading);
      // 0.5: from the pixel's centre out to the crack
      twice_area += c.x * kStepY[c.heading] - c.y * kStepX[c.heading] - 0.5;
      const Direction out = turned_right(c.heading);
      const int x = c.x + kStepX[out], y = c.y + kStepY[out];
      if (x != last_x || y != last_y) loop.points.push_back(point(x, y));
      last_x = x, last_y = y;
      c = next(c);
    } while (!(c == start));
    loop.outer = twice_area < 0;
    return loop;
  }

 private:
  std::size_t index(const Crack& c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(map_.width) +
           static_cast<std::size_t>(c.x);
  }
  bool is(int label, int x, int y) const { return map_.inside(x, y) && map_.at(x, y) == label; }

  /// Follows the region 4-connected: the pixel ahead must be reached through its side.
  Crack next(const Crack& c) const {
    const int label = map_.at(c.x, c.y);
    const Direction out = turned_right(c.heading);
    const int ahead_x = c.x + kStepX[c.heading], ahead_y = c.y + kStepY[c.heading];
    if (!is(label, ahead_x, ahead_y)) return {c.x, c.y, turned_left(c.heading)};
    const int diagonal_x = ahead_x + kStepX[out], diagonal_y = ahead_y + kStepY[out];
    if (!is(label, diagonal_x, diagonal_y)) return {ahead_x, ahead_y, c.heading};
    return {diagonal_x, diagonal_y, out};
  }

  Eigen::Vector2d point(int x, int y) const {
    return map_.inside(x, y) ? subpixel_contour(features_, x, y) : Eigen::Vector2d(x, y);
  }

  const RegionMap& map_;
  const ViewFeatures& features_;
  std::vector<std::uint8_t> visited_;
};

double magnitude_at(const ViewFeatures& f, double x, double y) {
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const double u = x - x0, v = y - y0;
  return (1 - v) * ((1 - u) * f.at(x0, y0).magnitude + u * f.at(x0 + 1, y0).magnitude) +
         v * ((1 - u) * f.at(x0, y0 + 1).magnitude + u * f.at(x0 + 1, y0 + 1).magnitude);
}

}  // namespace

Eigen::Vector2d subpixel_contour(const ViewFeatures& features, int x, int y) {
  const Eigen::Vector2d pixel(x, y);
  const ContourBeat& beat = features.at(x, y);
  const Eigen::Vector2d gradient(beat.gx, beat.gy);
  const bool at_border = x < 2 || y < 2 || x >= features.width - 2 || y >= features.height - 2;
  if (at_border || !beat.contour() || gradient.isZero()) return pixel;
  const Eigen::Vector2d n = gradient.normalized();
  const double before = magnitude_at(features, x - n.x(), y - n.y());
  const double after = magnitude_at(features, x + n.x(), y + n.y());
  const double bend = before - 2.0 * beat.magnitude + after;
  if (bend >= 0) return pixel;
  return pixel + n * std::clamp(0.5 * (before - after) / bend, -1.0, 1.0);
}

std::vector<std::vector<BoundaryLoop>> trace_boundaries(const RegionMap& map,
                                                        const ViewFeatures& features) {
  std::vector<std::vector<BoundaryLoop>> loops(static_cast<std::size_t>(map.regions));
  LoopTracer tracer(map, features);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      for (const Direction heading : {kRight, kUp, kLeft, kDown}) {
        const Crack start{x, y, heading};
        if (!tracer.open(start)) continue;
        loops[static_cast<std::size_t>(map.at(x, y) - 1)].push_back(tracer.trace(start));
      }
    }
  }
  return loops;
}

}  // namespace trihedron
