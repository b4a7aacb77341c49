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
  std::vector<int> labels;    ///< width * height, raster order

  int at(int x, int y) const {
    return labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

/// The contour pixels of a view (1) with the gaps closed: every contour end is joined by a
/// straight line to the nearest other contour pixel ahead of it, over at most `bridge_px`
/// missing pixels.
std::vector<std::uint8_t> bridged_contour(const ViewFeatures& features, int bridge_px);

/// Labels the 4-connected components between the contour pixels. Components below
/// `min_region_px` dissolve into their surroundings, and so do contour pixels that separate
/// nothing (dangling lines, the second row of thick contours).
RegionMap label_regions(const std::vector<std::uint8_t>& contour, int width, int height,
                        int min_region_px);

}  // namespace trihedron
