// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/report.hpp"
#include "sim/simulator.hpp"

namespace trihedron::sim {

struct RegisterValue {
  std::string name;
  std::uint32_t address = 0;
  std::uint32_t value = 0;
};

/// What puts `change` in force.
std::vector<RegisterValue> threshold_settings(const ThresholdChange& change);

/// What a run writes before the first pixel: thresholds and frame height.
std::vector<RegisterValue> run_settings(const RunOptions& options);

/// What the counters and the status must read after a run without a mismatch.
std::vector<RegisterValue> final_values(const RunOptions& options, const Report& report);

}  // namespace trihedron::sim
