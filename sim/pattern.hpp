// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/random.hpp"
#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// Contents of random test images. Each kind aims at another part of the pipeline.
enum class Pattern {
  kFlat,          ///< nothing to find
  kNoise,         ///< all 256 levels: every stage busy at every pixel
  kFaintNoise,    ///< +-4 levels around a mean: decisions near the noise floor
  kSaturated,     ///< only 0 and 255: largest sums of each mask
  kStep,          ///< one straight edge of any direction and height
  kPolygons,      ///< filled convex polygons: contours and vertices as in use
  kSinglePixels,  ///< a few lone pixels: impulse responses
  kRamp,          ///< constant slope of any direction
  kStripes,       ///< bars of 1 to 4 px, 0 and 255: largest alternating sums
  kPicture,       ///< a random crop of a real picture
  kExtremes,      ///< windows that drive a derivative mask to its largest or smallest sum
};
inline constexpr int kPatterns = 11;

/// A `width` x `height` px image of one kind. kPicture crops one of `pictures` (mirrored at its
/// borders where it is too small) and is kPolygons when there are none, as kExtremes in an image
/// without a whole window.
GreyImage make_image(Pattern pattern, int width, int height, Random& random,
                     const std::vector<GreyImage>& pictures);

}  // namespace trihedron::sim
