// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace trihedron {

/// Fraction bits of the gradient: a grey level per px is kGradientScale units.
constexpr int kGradientFractionBits = 3;
constexpr int kGradientScale = 1 << kGradientFractionBits;

/// Flags of one contour beat.
enum ContourFlag : std::uint8_t {
  kContour = 1,       ///< second contour: one pixel wide
  kFirstContour = 2,  ///< first contour: may be several pixels wide
};

/// One beat of the contour stream: what the hardware says of one pixel. One beat per input
/// pixel, in raster order.
struct ContourBeat {
  std::int16_t gx = 0;          ///< derivative along x (right), 1/kGradientScale grey level per px
  std::int16_t gy = 0;          ///< derivative along y (down), 1/kGradientScale grey level per px
  std::uint16_t magnitude = 0;  ///< mean of the four directional magnitudes, same unit
  std::uint8_t flags = 0;       ///< ContourFlag bits

  bool contour() const { return (flags & kContour) != 0; }
};

/// One record of the vertex stream.
struct Vertex {
  std::uint16_t x = 0;         ///< column, px
  std::uint16_t y = 0;         ///< row, px
  std::uint8_t branches = 0;   ///< contour branches that leave the 5x5 pixels around it, 0 .. 8
  std::uint16_t pattern = 0;   ///< 16 a + b, ring positions of the first and the last branch
  std::uint16_t strength = 0;  ///< vertex score, 25 .. 64 (golden/vertices.hpp)
};

/// Everything that leaves the hardware's ports for one frame of one view. Software sees
/// nothing else of the image.
struct ViewFeatures {
  int width = 0;                     ///< px
  int height = 0;                    ///< px
  std::vector<ContourBeat> contour;  ///< width * height beats, raster order
  std::vector<Vertex> vertices;      ///< in stream order
  std::uint32_t vertices_lost = 0;   ///< did not fit into the frame's list

  const ContourBeat& at(int x, int y) const {
    return contour[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

}  // namespace trihedron
