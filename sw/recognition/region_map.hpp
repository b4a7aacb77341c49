// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

/// Which region each pixel of a view belongs to.
struct RegionMap {
  static constexpr int kBackground = 0;  ///< connected to the image border
  static constexpr int kContour = -1;    ///< separates at least two regions

  int width = 0, height = 0;  ///< px
  int regions = 0;            ///< labels 1..regions, by first pixel in raster order
  std::vector<int> loose_px;  ///< per region: contour pixels inside that separate nothing
  std::vector<int> labels;    ///< width * height, raster order

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  int at(int x, int y) const { return labels[index(x, y)]; }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

/// Labels the 4-connected components between the contour pixels (`contour`: 1, raster order, the
/// size of `features`). Components that are smaller than `min_region_px` or very narrow dissolve
/// into their surroundings, and so do contour pixels that separate nothing (loose lines, thick
/// contours): what stays contour runs along the ridge of the gradient.
RegionMap label_regions(const std::vector<std::uint8_t>& contour, const ViewFeatures& features,
                        int min_region_px);

}  // namespace trihedron
