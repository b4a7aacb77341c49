// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sim/regression.hpp"

namespace trihedron::sim {

/// What the regression has been through: groups of bins with the number of times each was hit. All
/// bins exist from the start, so that one never hit shows. A case counts only when it has passed.
class FunctionalCoverage {
 public:
  using Bins = std::map<std::string, std::uint64_t>;

  FunctionalCoverage();

  /// The stimulus of a case and the events that it caused.
  void sample(const RegressionCase& stimulus, const Report& report);
  /// What came out.
  void sample(const FrameResult& frame);
  /// Throws Error on a group or bin that is not known.
  void add(const std::string& group, const std::string& bin, std::uint64_t times = 1);

  const std::map<std::string, Bins>& groups() const { return groups_; }

 private:
  void sample_frames(const RegressionCase& stimulus, std::size_t view);
  void sample_settings(const RunOptions& options);
  void sample_changes(const RunOptions& options);

  std::map<std::string, Bins> groups_;
};

}  // namespace trihedron::sim
