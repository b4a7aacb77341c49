// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

/// A closed polygon in the image, px: corners in counter-clockwise order as seen on the screen
/// (x right, y down, so its shoelace area in image coordinates is negative).
using ImagePolygon = std::vector<Eigen::Vector2d>;

/// A closed region of one view: what the paper calls a 2D surface.
struct Region {
  ImagePolygon outer;
  std::vector<ImagePolygon> holes;  ///< inner boundaries, clockwise as seen on the screen
  double area_px2 = 0;              ///< inside `outer` and outside all `holes`
  int loose_px = 0;                 ///< contour pixels inside that separate nothing
};

struct RegionOptions {
  /// Loose contour ends are joined straight to a contour over gaps of up to this many pixels.
  int bridge_px = 2;
  /// Components of fewer pixels are flaws of the contour, not regions: a region as small as the
  /// 5x5 window of the front end cannot have been resolved.
  int min_region_px = 25;
};

/// The closed regions of a view, in raster order of their topmost pixels: connected components
/// of the pixels between the second contours, with straight-line polygons as boundaries. The
/// background, i.e. whatever reaches the image border, is none of them. Corners are sub-pixel
/// intersections of lines fitted to the contour; the vertex stream proposes where to split.
/// A region whose boundary has fewer than three corners is left out.
std::vector<Region> find_regions(const ViewFeatures& features, const RegionOptions& options = {});

}  // namespace trihedron
