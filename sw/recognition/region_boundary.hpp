// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "golden/features.hpp"
#include "recognition/region_map.hpp"

namespace trihedron {

/// A closed chain of the contour points around a region or around a hole in it.
struct BoundaryLoop {
  std::vector<Eigen::Vector2d> points;  ///< sub-pixel, px; about one per pixel of its length
  bool outer = true;                    ///< counter-clockwise on the screen; holes clockwise
};

/// The boundary loops of every region, index = label - 1. Points are the contour pixels next
/// to the region, moved along the gradient to where its magnitude is largest.
std::vector<std::vector<BoundaryLoop>> trace_boundaries(const RegionMap& map,
                                                        const ViewFeatures& features);

/// The contour pixel (x, y) moved by at most one pixel along its gradient to the maximum of the
/// parabola through the magnitudes there and one pixel before and behind.
Eigen::Vector2d subpixel_contour(const ViewFeatures& features, int x, int y);

}  // namespace trihedron
