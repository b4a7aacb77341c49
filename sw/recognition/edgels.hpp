// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>
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

/// The edge points of a view, found again by their pixels.
class EdgelMap {
 public:
  EdgelMap(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        words_(static_cast<std::size_t>(width_px + 63) / 64),
        taken_(words_ * static_cast<std::size_t>(height_px), 0),
        first_(taken_.size(), 0) {}

  int width, height;          ///< px
  std::vector<Edgel> edgels;  ///< in raster order of their pixels
  float noise = 0;            ///< sigma of one component of the smoothed gradient, stream units

  /// Adds the edge point of pixel (x, y); pixels come in raster order.
  void add(int x, int y, const Edgel& edgel);

  /// The index of the pixel's edge point, or -1.
  int at(int x, int y) const {
    const std::size_t word = word_of(x, y);
    const std::uint64_t before = taken_[word] << (63 - x % 64);  // this pixel's bit on top
    return before >> 63 ? first_[word] + count_bits(before << 1) : -1;
  }

 private:
  std::size_t word_of(int x, int y) const {
    return static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(x) / 64;
  }
  static int count_bits(std::uint64_t bits) {
    return static_cast<int>(std::bitset<64>(bits).count());
  }

  // A bit per pixel and an index per 64 pixels: a twentieth of an index per pixel, so that the
  // look-ups of the mostly empty pixels stay in the cache.
  std::size_t words_;                 // per row
  std::vector<std::uint64_t> taken_;  // per pixel: it has an edge point
  std::vector<std::int32_t> first_;   // per word: index of its first edge point
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
