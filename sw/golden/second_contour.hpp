// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"
#include "golden/ridge.hpp"

namespace trihedron::golden {

/// Row y of stage 3, second window: the second contour from the ridge, seen through a 5x5 window of
/// ridge bits. The links of a pixel are its ridge neighbours among the 8.
///
///   A ridge pixel stays when it has a link.
///   A pixel off the ridge, with magnitude >= noise_floor, closes a gap of one pixel when its
///   links fall into two or more groups that do not touch (8 neighbours) and one of the links is
///   an end, that is, has one link.
///
/// So pieces of contour are joined, never cut. A closed gap may be no first contour.
/// A pixel whose 5x5 window leaves the image is 0.
void link_row(const Plane<std::uint8_t>& ridge, const Plane<std::uint16_t>& magnitude,
              int noise_floor, int y, Plane<std::uint8_t>& out);

/// All rows.
Plane<std::uint8_t> link(const Plane<std::uint8_t>& ridge, const Plane<std::uint16_t>& magnitude,
                         int noise_floor);

/// Stage 3: the ridge of the first contour, linked; one pixel wide.
inline Plane<std::uint8_t> second_contour(const GradientImage& gradient,
                                          const Plane<std::uint8_t>& first_contour, int noise_floor,
                                          const SecondContourConfig& config) {
  return link(ridge(gradient, first_contour, config), gradient.magnitude, noise_floor);
}

}  // namespace trihedron::golden
