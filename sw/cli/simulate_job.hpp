// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/frame_inputs.hpp"
#include "sim/report.hpp"

namespace trihedron::cli {

struct SimulateArguments {
  std::vector<std::string> inputs;
  std::string out, trace, stats, front_end = "rtl";
  std::uint64_t seed = 1;
  double idles = 0.0, stalls = 0.0;
  int limit = 0;
  bool check = false, skip_unreadable = false;
  bool spoil = false;  ///< check against thresholds that the hardware does not have
};

/// What a simulation of frames came to; parts of a job can be added up.
struct SimulationOutcome {
  std::uint64_t frames = 0, contour_px = 0, vertices = 0;
  std::uint64_t clocks = 0, pixels = 0, input_stalls = 0, input_idles = 0;
  std::uint64_t latency_clocks = 0;  ///< the largest
  sim::Compared compared;
  bool passed = true;    ///< with --check: everything was equal, and something was compared
  std::string mismatch;  ///< which input and what; empty: none

  void add(const SimulationOutcome& part);
  std::string to_text() const;
  static SimulationOutcome from_text(const std::string& text);
};

/// Sends the frames through the front end, images of a scene to their own views and others to
/// whichever view is free, and writes their features below `out`. `print` gets a line per frame,
/// in the order of the inputs. Ends early, with what is in the pipeline, on Ctrl-C.
SimulationOutcome simulate_frames(const SimulateArguments& arguments, FrameInputs& inputs,
                                  const std::function<void(const std::string& line)>& print);

}  // namespace trihedron::cli
