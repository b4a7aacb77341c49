// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/features.hpp"
#include "golden/first_contour.hpp"
#include "golden/second_contour.hpp"
#include "golden/vertices.hpp"

namespace trihedron::golden {

/// The front end's thresholds, with the reset values of the hardware's registers.
struct FrontEndConfig {
  FirstContourConfig first_contour;
  SecondContourConfig second_contour;
  VertexConfig vertices;
};

/// The features of one 8-bit grey image of `width` x `height` px, rows `stride` bytes apart:
/// gradient, first contour, second contour and vertices in turn. Bit-identical to the RTL.
/// Throws Error when the image is smaller than the smallest legal frame.
ViewFeatures run_front_end(const std::uint8_t* grey, int width, int height, int stride,
                           const FrontEndConfig& config = {});

}  // namespace trihedron::golden
