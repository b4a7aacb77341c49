// SPDX-License-Identifier: Apache-2.0
#include "recognition/direction_map.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// Single precision moves what is looked up by less, px and rad.
constexpr double kRounding = 1e-3;
/// As many pixels as SegmentGrid's cells cover, which are twice as wide.
unsigned cells(int px) {
  constexpr int kTwoPx = 2 * static_cast<int>(DirectionMap::kCellPx);
  return 2 * static_cast<unsigned>(std::max(1, (px + kTwoPx - 1) / kTwoPx));
}

}  // namespace

std::uint32_t DirectionBins::around(const Segment& s, double angle) {
  const auto turned = [&](double turn) {
    const double c = std::cos(turn), t = std::sin(turn);
    return bin(static_cast<float>(c * s.direction.x() - t * s.direction.y()),
               static_cast<float>(t * s.direction.x() + c * s.direction.y()));
  };
  std::uint32_t bits = 0;
  const unsigned last = turned(angle);
  for (unsigned b = turned(-angle);; b = (b + 1) % kCount) {
    bits |= 1U << b;
    if (b == last) return bits;
  }
}

DirectionMap::DirectionMap(const std::vector<Segment>& segments, int width_px, int height_px,
                           double tolerance_px, double max_sine)
    : columns_(cells(width_px)), rows_(cells(height_px)), bits_(columns_ * rows_, 0) {
  const double angle = std::asin(max_sine) + kRounding;
  for (const Segment& s : segments) {
    draw(s, tolerance_px + kRounding, DirectionBins::around(s, angle));
  }
}

/// Marks the cells within `reach` of a segment, row by row.
void DirectionMap::draw(const Segment& s, double reach, std::uint32_t bits) {
  constexpr double kPx = kCellPx;
  const auto cell = [](double px) { return static_cast<int>(std::floor(px / kPx)); };
  const double low = std::min(s.p0.y(), s.p1.y()), high = std::max(s.p0.y(), s.p1.y());
  const int last_row = std::min(cell(high + 2 * reach), static_cast<int>(rows_) - 1);
  for (int row = std::max(cell(low - 2 * reach), 0); row <= last_row; ++row) {
    // The part of the line from which the row's pixels are within reach.
    double from = -reach, to = s.length + reach;
    if (std::abs(s.direction.y()) > 1e-9) {
      const double a = (row * kPx - reach - s.p0.y()) / s.direction.y();
      const double b = ((row + 1) * kPx + reach - s.p0.y()) / s.direction.y();
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
      if (from > to) continue;
    }
    const double a = s.p0.x() + from * s.direction.x(), b = s.p0.x() + to * s.direction.x();
    const int last = std::min(cell(std::max(a, b) + reach), static_cast<int>(columns_) - 1);
    for (int column = std::max(cell(std::min(a, b) - reach), 0); column <= last; ++column) {
      bits_[static_cast<unsigned>(row) * columns_ + static_cast<unsigned>(column)] |= bits;
    }
  }
}

}  // namespace trihedron
