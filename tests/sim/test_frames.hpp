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
