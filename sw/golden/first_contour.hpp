// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Registers of stage 2, with their reset values.
struct FirstContourConfig {
  /// Smallest magnitude of a contour pixel, 1/kGradientScale grey level per px; 1 .. 511. Reset:
  /// the weakest edge of interest, 8 grey levels high, has 0.19 to 0.22 of its height.
  int noise_floor = 12;
  /// The mean of the neighbours not above the centre is less than this many 1/32 of it; 1 .. 31.
  /// Reset: a step edge blurred by sigma px has 12 to 20 (sigma <= 0.8), 20 to 23 (1.2), 25 to 27
  /// (2): focused edges pass, the soft borders of shadows do not.
  int mean_limit = 21;
};

/// Row y of stage 2: 1 where a contour may run, 0 elsewhere. With c the magnitude of the centre and
/// n those of its window's 24 other pixels, a pixel is first contour when
///
///   c >= noise_floor                                          it stands above the noise,
///   32 sum{n <= c} n < mean_limit * c * count{n <= c}         it outweighs what is not above it,
///   4 p >= 3 c  and  4 q >= 3 c                               and a path runs through it,
///
/// for two of the 8 inner neighbours p and q that do not touch each other: the 16 ways in which a
/// path of touching pixels can pass the centre of 3x3 pixels. May be several pixels wide. A pixel
/// whose 5x5 window leaves the image is 0.
void first_contour_row(const Plane<std::uint16_t>& magnitude, const FirstContourConfig& config,
                       int y, Plane<std::uint8_t>& out);

/// All rows.
Plane<std::uint8_t> first_contour(const Plane<std::uint16_t>& magnitude,
                                  const FirstContourConfig& config);

}  // namespace trihedron::golden
