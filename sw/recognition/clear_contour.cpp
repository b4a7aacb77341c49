// SPDX-License-Identifier: Apache-2.0
#include "recognition/clear_contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace trihedron {
namespace {

/// Least smoothed gradient, in standard deviations of its noise: pure noise reaches it in one pixel
/// of 90 (Rayleigh), and contour pixels have passed the front end's tests of path and support
/// besides. In a quiet image the hardware's threshold is higher.
constexpr float kLeastStrength = 3.0F;

/// Length of the gradient smoothed with the 3x3 binomial, as that of the edge points.
float smoothed(const ViewFeatures& features, int x, int y) {
  int gx = 0, gy = 0;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const int weight = (2 - std::abs(i)) * (2 - std::abs(j));
      const ContourBeat& beat = features.at(x + i, y + j);
      gx += weight * beat.gx;
      gy += weight * beat.gy;
    }
  }
  return std::hypot(static_cast<float>(gx), static_cast<float>(gy)) / 16;
}

}  // namespace

std::vector<ContourPixel> clear_contour(const ViewFeatures& features, float noise) {
  constexpr int kTogether = 8;  // most pixels are none: asked for in groups
  std::vector<ContourPixel> out;
  for (int y = 1; y + 1 < features.height; ++y) {  // contours keep off the image's border
    const ContourBeat* row = &features.at(0, y);
    for (int first = 1; first + 1 < features.width; first += kTogether) {
      const int end = std::min(first + kTogether, features.width - 1);
      unsigned flags = 0;
      for (int x = first; x < end; ++x) flags |= row[x].flags;
      if ((flags & kContour) == 0) continue;
      for (int x = first; x < end; ++x) {
        if (!row[x].contour() || smoothed(features, x, y) < kLeastStrength * noise) continue;
        out.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)});
      }
    }
  }
  return out;
}

}  // namespace trihedron
