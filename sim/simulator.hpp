// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/features.hpp"
#include "golden/front_end.hpp"
#include "sim/report.hpp"
#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// Registers that are written while every view is in the middle of a frame that `holds`; they are
/// in force from the next frame on.
struct SettingsChange {
  golden::FrontEndConfig thresholds;
  int vertex_limit = kMaxVertexLimit;
  int frame_height = 0;          ///< lines; 0: not known
  unsigned enabled = kAllViews;  ///< one bit per view; the frames of others are dropped
  /// Written with CONTROL.hold: all but `enabled` waits until a change without it.
  bool held = false;
};

/// Whether this build counts lines and toggles of the RTL.
extern const bool kCountsCodeCoverage;

struct RunOptions {
  std::uint64_t seed = 1;  ///< of all stalls; printed with every mismatch
  StallProfile pixel_idles;
  StallProfile contour_stalls;
  StallProfile vertex_stalls;
  StallProfile register_stalls;
  golden::FrontEndConfig thresholds;  ///< written over AXI4-Lite before the first pixel
  /// What the scoreboard expects; differs from `thresholds` only to see the scoreboard bite.
  std::optional<golden::FrontEndConfig> expected_thresholds;
  int vertex_limit = kMaxVertexLimit;   ///< vertices sent per frame, for the VERTEX_LIMIT register
  std::vector<SettingsChange> changes;  ///< one for each frame per view that `holds`, in order
  int frame_height = 0;  ///< lines, for the FRAME_HEIGHT register; 0: known from the stream
  /// Idle clocks that end a frame of unknown height. A SourceFrame's gap is either far shorter or
  /// far longer, so that stalls cannot turn one into the other.
  int flush_timeout = kDefaultFlushTimeout;
  bool check = false;  ///< hold everything against the golden model
  /// Clocks of random pixels and register writes before the run, ended by a reset in mid-frame.
  int prelude_clocks = 0;
  /// Reads every register after reset, writes byte by byte, to read-only registers and to addresses
  /// without one, and clears STATUS bit by bit at the end.
  bool exercise_registers = false;
  /// Reads STATUS and counters while frames run and writes back what STATUS said, as a driver does.
  bool poll_registers = false;
  std::string trace_file;              ///< FST waveform of the run; empty: none
  std::uint64_t trace_from_clock = 0;  ///< since reset; earlier clocks are not written
  /// Verilator's line and toggle counts of all runs of this process so far; needs a build with
  /// TRIHEDRON_RTL_COVERAGE.
  std::string code_coverage_file;
};

/// One frame as it left the hardware.
struct FrameResult {
  int view = 0;
  std::int64_t index = 0;  ///< of this view's output frames, from 0
  ViewFeatures features;
  std::uint16_t status = 0;          ///< frame status flags of the end-of-frame record; 0: clean
  std::uint64_t latency_clocks = 0;  ///< first pixel in to its contour beat out
  std::uint64_t clocks = 0;          ///< first pixel in to last contour beat out, both included
  std::uint64_t input_stalls = 0;    ///< clocks with a pixel offered but not accepted, until its end
  std::uint64_t contour_stalls = 0;  ///< clocks with a contour beat offered but not taken
};
using FrameSink = std::function<void(FrameResult&&)>;

/// The simulated hardware: three view pipelines behind SystemC drivers and monitors. SystemC
/// elaborates once per process, so there is one Simulator, and it is reused.
class Simulator {
 public:
  /// The process's simulator, elaborated at the first call. Not thread-safe.
  static Simulator& instance();

  /// Resets the hardware, writes the registers, sends every frame of `source` to its view (all
  /// views at once) and hands each output frame to `sink`. Stops at the first difference.
  /// Throws Error on misuse and whatever `source` and `sink` throw.
  Report run(const RunOptions& options, const FrameSource& source, const FrameSink& sink);

  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

 private:
  Simulator();
  ~Simulator() = default;
};

/// The features of one image per view, at most kViews, simulated side by side. Throws Error when
/// an image is outside the legal sizes or, with `options.check`, on a mismatch.
std::vector<ViewFeatures> simulate_views(const std::vector<GreyImage>& views,
                                         const RunOptions& options = {}, Report* report = nullptr);

}  // namespace trihedron::sim
