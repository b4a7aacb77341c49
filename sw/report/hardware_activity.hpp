// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace trihedron::report {

/// What one view's streams did while the hardware worked on a scene. Clocks.
struct ViewActivity {
  std::uint64_t pixels = 0;          ///< accepted at the input
  std::uint64_t input_stalls = 0;    ///< clocks with a pixel offered but not accepted
  std::uint64_t input_idles = 0;     ///< clocks without a pixel offered, first to last pixel
  std::uint64_t contour_beats = 0;   ///< handed over at the contour stream
  std::uint64_t contour_stalls = 0;  ///< clocks with a beat offered but not taken
  std::uint64_t latency_clocks = 0;  ///< first pixel in to its contour beat out
  std::uint64_t vertices = 0;
  std::uint64_t vertices_lost = 0;  ///< did not fit into the frame's list
  std::uint64_t stream_errors = 0;  ///< faults that the input stream held
};

/// The simulated hardware at work on one scene; nothing of it exists for the golden model.
struct HardwareActivity {
  std::uint64_t clocks = 0;  ///< from the end of reset to the last record
  std::vector<ViewActivity> views;
};

}  // namespace trihedron::report
