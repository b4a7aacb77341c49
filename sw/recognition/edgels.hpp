// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

/// A point of an edge: a ridge of the smoothed gradient, with sub-pixel position.
struct Edgel {
  float x = 0, y = 0;    ///< image position, px (distorted image, as observed)
  float nx = 0, ny = 0;  ///< unit gradient: from dark to bright
  float strength = 0;    ///< gradient magnitude in units of its noise
};

/// The edge points of a view and a map that finds them by pixel.
struct EdgelMap {
  int width = 0, height = 0;      ///< px
  std::vector<Edgel> edgels;      ///< in raster order of their pixels
  std::vector<std::int32_t> map;  ///< width * height: index of the pixel's edgel or -1
  float noise = 0;                ///< sigma of one component of the smoothed gradient, stream units

  int at(int x, int y) const {
    return map[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)];
  }
};

struct EdgelOptions {
  /// Weakest ridge kept, in sigmas of the smoothed gradient's noise. A Rayleigh magnitude passes
  /// 2.5 by chance in 4 % of the pixels; chance ridges do not line up into segments.
  float weakest = 2.5F;
  /// Smallest noise assumed, stream units: rounding leaves this much on noise-free images.
  float noise_floor = 1.0F;
};

/// Edge points of a view from its contour stream alone: the gradient components are smoothed
/// with a 3x3 binomial, ridges of the magnitude are located with a parabola across the edge.
/// The noise is estimated from the median magnitude (most pixels lie on no edge).
EdgelMap find_edgels(const ViewFeatures& features, const EdgelOptions& options = {});

}  // namespace trihedron
