// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "golden/front_end.hpp"
#include "sim/random.hpp"

namespace trihedron::parameters {

/// What one view's camera sends, and what must come out for it.
struct Frame {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
};

struct Expected {
  int width = 0;
  ViewFeatures features;
  unsigned status = 0;  ///< of the end-of-frame record
};

struct Camera {
  std::deque<Frame> frames;
  std::vector<Expected> expected;
  unsigned events = 0;  ///< STATUS bits that the frames set
};

/// Noise, or rectangles and triangles with or without noise: every stage has something to find.
inline Frame random_frame(int width, int height, sim::Random& random) {
  Frame frame{width, height, {}};
  frame.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 60);
  const int kind = random.between(0, 2);
  for (int shape = 0; shape < 4; ++shape) {
    const int left = random.between(0, width - 1), right = random.between(left, width - 1);
    const int top = random.between(0, height - 1), bottom = random.between(top, height - 1);
    const int level = random.between(0, 255), slope = random.between(0, 2);
    for (int y = top; y <= bottom; ++y)
      for (int x = std::min(right, left + slope * (y - top)); x <= right; ++x)
        frame.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(level);
  }
  for (std::uint8_t& pixel : frame.pixels) {
    if (kind == 0) pixel = static_cast<std::uint8_t>(random.between(0, 255));
    if (kind == 1) pixel = static_cast<std::uint8_t>(std::min(255, pixel + random.between(0, 6)));
  }
  return frame;
}

/// Frames of all sizes that an instance of this size takes, among them some too wide, which must
/// not come out, and some too tall, which must be cut.
inline Camera random_camera(int frames, int max_width, int max_height, sim::Random& random) {
  constexpr int kLeast = golden::kMinFrameSide;
  constexpr unsigned kTooWide = 1 << 2, kTooTall = 1 << 4, kBadHeight = 2;
  Camera camera;
  const auto add = [&](int width, int height, int rows, unsigned status) {
    camera.frames.push_back(random_frame(width, height, random));
    const Frame& frame = camera.frames.back();
    if (rows > 0)
      camera.expected.push_back(
          {width, golden::run_front_end(frame.pixels.data(), width, rows, width), status});
  };
  for (int i = 0; i < frames; ++i) {
    const int kind = random.between(0, 9);
    if (kind == 0) {
      add(max_width + random.between(1, 3), 2, 0, 0);
      camera.events |= kTooWide;
    } else if (kind == 1) {
      const int width = random.between(kLeast, std::min(max_width, 8));
      add(width, max_height + random.between(1, 2), max_height, kBadHeight);
      camera.events |= kTooTall;
    } else {
      const int width = kind == 2   ? max_width
                        : kind == 3 ? kLeast
                                    : random.between(kLeast, std::min(max_width, 160));
      const int height = random.between(kLeast, std::min(max_height, kind == 2 ? 12 : 40));
      add(width, height, height, 0);
    }
  }
  return camera;
}

}  // namespace trihedron::parameters
