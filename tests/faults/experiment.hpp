// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "faults/stream_bench.hpp"

namespace trihedron::faults {

/// Frames to send to all views, and what must come out of each.
struct Scene {
  struct View {
    std::vector<sim::SourceFrame> frames;
    std::vector<ViewOutput> expected;  ///< of each frame, from the golden model
  };
  std::uint64_t seed = 0;
  int frame_height = 0;  ///< for FRAME_HEIGHT; 0: not known
  std::array<View, sim::kViews> views;
};

/// Small frames of equal or changing width, drawn from `seed`.
Scene make_scene(std::uint64_t seed);

/// What became of an upset.
enum class Consequence {
  kMasked,      ///< every frame as it should be
  kOneFrame,    ///< one frame wrong, all others right
  kTwoFrames,   ///< two frames wrong, or one missing or too many
  kMoreFrames,  ///< more wrong, but right again by the second next frame
  kLate,        ///< right again, later than that
  kTags,        ///< all frames right, but their tags shifted
  kRegisters,   ///< right again only after the registers were written again
  kReset,       ///< not right again without a reset
};
inline constexpr int kConsequences = 8;

struct Upset {
  std::uint64_t scene = 0;  ///< seed of its frames
  std::uint64_t clock = 0;
  std::size_t flip_flop = 0;
  std::string name;  ///< of the flip-flop's variable
  Consequence consequence = Consequence::kMasked;
  std::string details;  ///< for a person: matching frames of each view
};

/// Clocks at which an upset may come so that whole frames follow: found by a run without one.
/// Throws std::runtime_error when that run is not right, or the registers do not answer.
struct Window {
  std::uint64_t first = 0, last = 0;
  std::vector<std::size_t> flip_flops;  ///< all there are
};
Window dry_run(const Scene& scene);

/// The flip-flop of this name, as Upset tells it: numbers shift when the RTL changes.
/// Throws std::runtime_error when there is none.
std::size_t flip_flop_called(const std::string& name);

/// Sends the scene with one flip-flop flipped in front of one clock, and judges what comes out.
Upset run_upset(const Scene& scene, std::uint64_t clock, std::size_t flip_flop);

}  // namespace trihedron::faults
