// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sim/pattern.hpp"
#include "sim/simulator.hpp"

namespace trihedron::sim {

/// A frame of polygons: contours and vertices in it.
inline GreyImage polygons(int width, int height, std::uint64_t seed) {
  Random random(seed);
  return make_image(Pattern::kPolygons, width, height, random, {});
}

/// Squares of 6 px: corners everywhere, also near the last rows and columns.
inline GreyImage squares(int width, int height, Random& random) {
  GreyImage image{width, height, {}};
  const int left = random.between(0, 11), above = random.between(0, 11);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixels.push_back((x + left) % 12 < 6 && (y + above) % 12 < 6 ? 200 : 40);
    }
  }
  return image;
}

inline SourceFrame frame_of(GreyImage image) {
  SourceFrame frame;
  frame.image = std::move(image);
  return frame;
}

/// The same `frames` for every view.
inline FrameSource for_all_views(const std::vector<SourceFrame>& frames) {
  std::vector<std::size_t> sent(kViews);
  return [frames, sent](int view) mutable -> std::optional<SourceFrame> {
    std::size_t& next = sent[static_cast<std::size_t>(view)];
    if (next == frames.size()) return std::nullopt;
    return frames[next++];
  };
}

}  // namespace trihedron::sim
