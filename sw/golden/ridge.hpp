// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Register of stage 3, with its reset value.
struct SecondContourConfig {
  /// Smallest sum of the window's first-contour magnitudes, 1/kGradientScale grey level per px;
  /// 0 .. 12775 (25 * 511). Reset: an edge of the weakest magnitude, 12, fills a band of 3 x 5
  /// pixels of the window; 4/5 of that. Grain makes shorter pieces.
  int support = 144;
};

/// Row y of stage 3, first window: 1 where a first-contour pixel lies on the ridge of the magnitude
/// m.
///
///   sum{5x5, first contour} m >= support                      enough contour around it,
///   m(p - s) < m(p) and m(p + s) <= m(p)                      highest across the contour,
///
/// with s the step across, (1, 0) for 2|gy| < |gx|, (0, 1) for 2|gx| < |gy|, else (1, 1) where gx
/// and gy have one sign (zero counts as positive) and (1, -1) where they differ. Of two equal
/// magnitudes side by side the first in raster order along s is the ridge. A pixel whose 5x5
/// window leaves the image is 0.
void ridge_row(const GradientImage& gradient, const Plane<std::uint8_t>& first_contour,
               const SecondContourConfig& config, int y, Plane<std::uint8_t>& out);

/// All rows.
Plane<std::uint8_t> ridge(const GradientImage& gradient, const Plane<std::uint8_t>& first_contour,
                          const SecondContourConfig& config);

}  // namespace trihedron::golden
