// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "recognition/segments.hpp"

namespace trihedron {

/// Directions in the image modulo 180 degrees, in bins of about 6 degrees.
struct DirectionBins {
  static constexpr int kCount = 32;

  /// The direction's place around the half circle, 0 to kCount: monotonic in the angle, and cheaper
  /// than one. The vector may have any length.
  static float place(float dx, float dy) {
    if (dy < 0) dx = -dx, dy = -dy;
    return (1 - dx / (std::abs(dx) + dy)) * (kCount / 2);
  }
  /// The same for a SIMD register of directions; 0 / 0 gives no place.
  template <typename Lanes>
  static Lanes places(const Lanes& dx, const Lanes& dy) {
    const Lanes x = dy < 0 ? -dx : dx, y = dy < 0 ? -dy : dy;
    return (1 - x / ((dx < 0 ? -dx : dx) + y)) * (kCount / 2);
  }
  static unsigned bin(float dx, float dy) { return static_cast<unsigned>(place(dx, dy)) % kCount; }
  /// The bits of all bins within `angle` of a segment's direction.
  static std::uint32_t around(const Segment& segment, double angle);
};

/// Which directions the segments near a place have: a bit each. It may say yes where
/// SegmentGrid::find finds none, never no where it finds one, and is several times as fast.
class DirectionMap {
 public:
  static constexpr unsigned kCellPx = 4;

  /// Tolerances as of SegmentGrid.
  DirectionMap(const std::vector<Segment>& segments, int width_px, int height_px,
               double tolerance_px, double max_sine);

  unsigned columns() const { return columns_; }
  unsigned rows() const { return rows_; }
  bool covers(double x_px, double y_px) const {
    return x_px >= 0 && y_px >= 0 && x_px < columns_ * kCellPx && y_px < rows_ * kCellPx;
  }
  /// The directions at a place that the map covers.
  std::uint32_t at(double x_px, double y_px) const {
    return cell(static_cast<unsigned>(x_px) / kCellPx, static_cast<unsigned>(y_px) / kCellPx);
  }
  std::uint32_t cell(unsigned column, unsigned row) const { return bits_[row * columns_ + column]; }

 private:
  void draw(const Segment& segment, double reach, std::uint32_t bits);

  unsigned columns_, rows_;
  std::vector<std::uint32_t> bits_;  ///< per cell
};

}  // namespace trihedron
