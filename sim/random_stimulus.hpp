// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim/random.hpp"
#include "sim/simulator.hpp"
#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// The dice of the regression: one function for each thing that a case draws.

struct Size {
  int width = 0;   ///< px
  int height = 0;  ///< px
};
/// A legal size. The extremes are narrow in the other direction: a frame costs about 10,000 clocks,
/// one in fifty up to 150,000.
Size random_size(Random& random);

/// None, 10 %, 50 %, bursts of up to 64 clocks, and rare stops of up to kLongestStallClocks, as
/// `kind` modulo kStallKinds says.
StallProfile stalls_of_kind(std::uint64_t kind);
inline constexpr std::uint64_t kStallKinds = 6;  ///< none twice
StallProfile random_stalls(Random& random);
inline constexpr int kLongestStallClocks = 2000;

/// Register values in force at the start: anywhere in their ranges, or reset values.
golden::FrontEndConfig random_thresholds(Random& random);
int random_vertex_limit(Random& random);
/// 16 .. 64 only where the source makes no pauses of its own; mostly 512 .. 1500.
int random_flush_timeout(const StallProfile& pixel_idles, Random& random);

/// Clocks before a frame: either far below the flush timeout, or so far above it that the frame
/// before has ended even when back-pressure keeps several lines of it waiting.
int random_gap(const Size& size, const RunOptions& options, Random& random);

/// Breaks a good frame: one of the Faults, or a size that is not legal.
void add_fault(SourceFrame& frame, Random& random);

}  // namespace trihedron::sim
