// SPDX-License-Identifier: Apache-2.0
#include "recognition/segment_grid.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/direction_map.hpp"

namespace trihedron {
namespace {

using Eigen::Vector2d;

constexpr int kCellPx = 8;
/// Half a cell's diagonal, px.
constexpr double kCellReach = kCellPx * 0.7072;
/// Distance of a point from a segment (its ends included), px.
double distance(const Segment& s, const Vector2d& p) {
  const double t = std::clamp(s.along(p), 0.0, s.length);
  return (p - s.p0 - t * s.direction).norm();
}

int cells(int px) { return std::max(1, (px + kCellPx - 1) / kCellPx); }

}  // namespace

SegmentGrid::SegmentGrid(const std::vector<Segment>& segments, int width_px, int height_px,
                         double tolerance_px, double max_sine)
    : columns_(cells(width_px)),
      rows_(cells(height_px)),
      reach_(static_cast<float>(tolerance_px)),
      max_sine_(static_cast<float>(max_sine)),
      directions_(static_cast<std::size_t>(columns_ * rows_), 0) {
  constexpr double kRounding = 1e-3;  // rad
  const double angle = std::asin(max_sine) + kRounding, reach = tolerance_px + kCellReach;
  std::vector<std::vector<std::int32_t>> near(directions_.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    strokes_.push_back({static_cast<float>(s.normal.x()), static_cast<float>(s.normal.y()),
                        static_cast<float>(s.normal.dot(s.p0)),
                        static_cast<float>(s.direction.dot(s.p0)), static_cast<float>(s.length)});
    const std::uint32_t directions = DirectionBins::around(s, angle);
    const auto cell = [&](double px, int count) {
      return std::clamp(static_cast<int>(std::floor(px / kCellPx)), 0, count - 1);
    };
    const Vector2d low = s.p0.cwiseMin(s.p1), high = s.p0.cwiseMax(s.p1);
    for (int y = cell(low.y() - reach, rows_); y <= cell(high.y() + reach, rows_); ++y) {
      for (int x = cell(low.x() - reach, columns_); x <= cell(high.x() + reach, columns_); ++x) {
        if (distance(s, {(x + 0.5) * kCellPx, (y + 0.5) * kCellPx}) > reach) continue;
        const auto at = static_cast<std::size_t>(y * columns_ + x);
        near[at].push_back(static_cast<std::int32_t>(i));
        directions_[at] |= directions;
      }
    }
  }
  start_.push_back(0);
  for (const auto& list : near) {
    segment_.insert(segment_.end(), list.begin(), list.end());
    start_.push_back(static_cast<std::int32_t>(segment_.size()));
  }
}

int SegmentGrid::find(float x, float y, float dx, float dy) const {
  if (!(x >= 0 && y >= 0)) return kOutside;
  const auto column = static_cast<int>(x) / kCellPx, row = static_cast<int>(y) / kCellPx;
  if (column >= columns_ || row >= rows_) return kOutside;
  const auto cell = static_cast<std::size_t>(row * columns_ + column);
  // Most places have no contour of a given direction: one bit says so.
  if (!(directions_[cell] >> DirectionBins::bin(dx, dy) & 1)) {
    return kMiss;
  }
  int found = kMiss;
  float best = reach_;
  for (auto i = start_[cell]; i < start_[cell + 1]; ++i) {
    const int k = segment_[static_cast<std::size_t>(i)];
    const Stroke& s = strokes_[static_cast<std::size_t>(k)];
    const float across = std::abs(s.nx * x + s.ny * y - s.offset);
    if (across >= best || std::abs(s.nx * dx + s.ny * dy) > max_sine_) continue;
    const float t = s.ny * x - s.nx * y - s.start;
    if (t < -reach_ || t > s.length + reach_) continue;
    best = across;
    found = k;
  }
  return found;
}

}  // namespace trihedron
