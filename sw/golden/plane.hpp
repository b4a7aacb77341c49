// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace trihedron::golden {

/// Radius of every stage's 5x5 window, px: pixels nearer to the border have no whole window.
constexpr int kWindowRadius = 2;

/// Side of the smallest legal frame, px: one whole 5x5 window.
constexpr int kMinFrameSide = 2 * kWindowRadius + 1;

/// Rows that a plane of line memories keeps: a power of two, at least the 7 that lie between a
/// row's first and last use in the chain of stages (front_end.cpp).
constexpr int kLineMemoryRows = 8;

/// One value per pixel of a frame, in raster order. Every stage has the frame geometry of its
/// input: value (x, y) belongs to pixel (x, y). A plane may keep its latest rows only, as line
/// memories do: row y then takes the place of row y - kLineMemoryRows.
template <typename T>
struct Plane {
  int width = 0;   ///< px
  int height = 0;  ///< px
  std::vector<T> samples;

  Plane() = default;
  Plane(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        samples(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {}

  /// A plane that keeps its latest kLineMemoryRows rows.
  static Plane line_memories(int width_px, int height_px) {
    Plane plane(width_px, kLineMemoryRows);
    plane.height = height_px;
    plane.row_mask_ = kLineMemoryRows - 1;
    return plane;
  }

  T* row(int y) { return samples.data() + offset(y); }
  const T* row(int y) const { return samples.data() + offset(y); }
  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }

 private:
  std::size_t row_mask_ = ~std::size_t{0};

  std::size_t offset(int y) const {
    return (static_cast<std::size_t>(y) & row_mask_) * static_cast<std::size_t>(width);
  }
};

/// Sets row y to 0. Returns whether it has pixels with whole windows inside the frame: the others
/// stay 0 in every stage.
template <typename T>
bool clear_row(Plane<T>& plane, int y) {
  std::fill_n(plane.row(y), plane.width, T{0});
  return y >= kWindowRadius && y < plane.height - kWindowRadius;
}

}  // namespace trihedron::golden
