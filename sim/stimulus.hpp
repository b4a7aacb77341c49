// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace trihedron::sim {

inline constexpr int kViews = 3;  ///< view pipelines in the simulated top
inline constexpr unsigned kAllViews = (1u << kViews) - 1;
inline constexpr int kMinSizePx = 5;       ///< smallest legal frame width and height
inline constexpr int kMaxWidthPx = 1920;   ///< widest frame that the simulated build takes
inline constexpr int kMaxHeightPx = 1200;  ///< tallest frame that the simulated build takes

inline constexpr int kDefaultFlushTimeout = 4096;  ///< clocks

inline constexpr int kMaxVertexLimit = 65535;

/// Longest gap that a source may leave before a frame.
inline constexpr int kMaxGapClocks = 1 << 17;

/// An 8-bit grey image: `width * height` pixels in raster order.
struct GreyImage {
  int width = 0;   ///< px
  int height = 0;  ///< px
  std::vector<std::uint8_t> pixels;
};

/// What is wrong with a frame on its way into the hardware. Size faults need no entry: an image
/// that is too narrow, wide, low or tall is sent as it is.
enum class Fault {
  kNone,
  kShortLine,     ///< line `fault_line` ends early
  kLongLine,      ///< line `fault_line` is longer than the first
  kMissingStart,  ///< no start of frame at the first pixel
  kEarlyStart,    ///< a start of frame in the middle of line `fault_line`
  kCutFrame,      ///< the frame stops after line `fault_line`, the next one follows at once
};
inline constexpr int kFaults = 6;

/// One frame as it is sent to one view's pixel stream.
struct SourceFrame {
  GreyImage image;
  Fault fault = Fault::kNone;
  int fault_line = 0;  ///< row that `fault` is about
  int fault_px = 1;    ///< columns missing, too many, or before the stray start of frame
  bool holds = false;  ///< the sender waits in line 0 until all views do and thresholds are changed
  int gap_clocks = 0;  ///< idle clocks before the first pixel, at most kMaxGapClocks
};

/// When a stream's sender or receiver stalls: at any clock with `probability`, for 1 to `longest`
/// clocks (uniform).
struct StallProfile {
  double probability = 0.0;
  int longest = 1;
};

/// The next frame of `view`, or nothing when the view's sequence is over. Called for each view
/// in turn as the simulation needs it, so that a sequence of any length takes constant memory.
using FrameSource = std::function<std::optional<SourceFrame>(int view)>;

}  // namespace trihedron::sim
