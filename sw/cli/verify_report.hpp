// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/functional_coverage.hpp"
#include "sim/report.hpp"

namespace trihedron::cli {

/// What one case of the regression came to; travels between processes as text.
struct CaseOutcome {
  std::uint64_t seed = 0;
  double seconds = 0.0;
  std::uint64_t clocks = 0;
  sim::Compared compared;
  std::string failure;              ///< empty: all equal
  bool skipped = false;             ///< an earlier case failed
  sim::FunctionalCoverage covered;  ///< by this case alone

  std::string to_text() const;
  static CaseOutcome from_text(const std::string& text);
};

/// A JUnit report, one test case a seed, with the command that `repeat` gives at each failure.
/// Throws Error when the disk refuses.
void write_junit(const std::string& file, const std::vector<CaseOutcome>& outcomes,
                 const std::function<std::string(const CaseOutcome&)>& repeat);

/// Functional coverage of all cases as JSON: seeds, frames, groups of bins with hit counts. Throws
/// Error when the file cannot be written.
void write_coverage(const std::string& file, const std::vector<CaseOutcome>& outcomes);

}  // namespace trihedron::cli
