// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace trihedron::golden {

/// One value per pixel of a frame, in raster order. Every stage has the frame geometry of its
/// input: value (x, y) belongs to pixel (x, y).
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

  T* row(int y) { return samples.data() + offset(y); }
  const T* row(int y) const { return samples.data() + offset(y); }
  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }

 private:
  std::size_t offset(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

/// Radius of every stage's 5x5 window, px: pixels nearer to the border have no whole window.
constexpr int kWindowRadius = 2;

/// Side of the smallest legal frame, px: one whole 5x5 window.
constexpr int kMinFrameSide = 2 * kWindowRadius + 1;

}  // namespace trihedron::golden
