// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "recognition/segments.hpp"

namespace trihedron {

/// The segments of a view, found by place and direction.
class SegmentGrid {
 public:
  static constexpr int kMiss = -1, kOutside = -2;

  /// `tolerance_px`: of a point from a segment, across and beyond its ends; `max_sine`: of the
  /// angle between a direction and a segment's.
  SegmentGrid(const std::vector<Segment>& segments, int width_px, int height_px,
              double tolerance_px, double max_sine);

  /// The index of the segment nearest to an image position, across, among those of the direction
  /// (dx, dy), a unit vector of either sign; kMiss: none within the tolerances, kOutside: not in
  /// the image.
  int find(float x, float y, float dx, float dy) const;

 private:
  /// A segment as the look-up needs it.
  struct Stroke {
    float nx, ny, offset;  ///< distance of p: n . p - offset, px
    float start, length;   ///< along (ny, -nx), px
  };

  int columns_, rows_;
  float reach_, max_sine_;
  std::vector<std::uint32_t> directions_;  ///< per cell: a bit for every direction found there
  std::vector<std::int32_t> start_;        ///< per cell: its range in `segment_`
  std::vector<std::int32_t> segment_;      ///< segments that pass near the cell
  std::vector<Stroke> strokes_;            ///< per segment
};

}  // namespace trihedron
