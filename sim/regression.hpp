// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/pattern.hpp"
#include "sim/report.hpp"
#include "sim/simulator.hpp"
#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// One random run of the regression: everything in it follows from `options.seed`.
struct RegressionCase {
  RunOptions options;
  std::array<std::vector<SourceFrame>, kViews> frames;  ///< per view
  std::array<std::vector<Pattern>, kViews> contents;    ///< of each frame
};

class FunctionalCoverage;

/// How many frames the case of `seed` sends, over all views; cheap.
int frames_in_case(std::uint64_t seed);

/// Sizes, contents, thresholds, stalls and stream faults drawn from `seed`; `pictures` are real
/// images to crop from and may be empty.
RegressionCase make_case(std::uint64_t seed, const std::vector<GreyImage>& pictures = {});

/// Simulates the case, checked against the golden model. A case that passes is counted in
/// `coverage`, if any.
Report run_case(const RegressionCase& regression_case, FunctionalCoverage* coverage = nullptr);

}  // namespace trihedron::sim
