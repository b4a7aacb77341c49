// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace trihedron::bench {

/// Two benchmarks to be set side by side, by the names they are registered with.
struct Ratio {
  std::string what;         ///< what the line of the table says
  std::string numerator;    ///< its time is divided
  std::string denominator;  ///< by this one's
};

/// Runs the registered benchmarks and prints a table of `ratios`. The benchmarks take turns in
/// random order, `repetitions` times each, and the medians of their CPU times are compared: what
/// else runs on the machine meets all of them alike. Returns the program's exit code, 1 on
/// options that Google Benchmark does not know.
int run_and_compare(int argc, char** argv, const std::vector<Ratio>& ratios, int repetitions);

}  // namespace trihedron::bench
