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
std::vector<RegisterValue> change_settings(const SettingsChange& change);

/// Of each of the settings the first one with the same thresholds and VERTEX_LIMIT.
std::vector<int> first_alike(const std::vector<SettingsChange>& settings);

/// What a run writes before the first pixel.
std::vector<RegisterValue> run_settings(const RunOptions& options);

/// What settings and counters must read after a run without a mismatch.
std::vector<RegisterValue> final_values(const RunOptions& options, const Report& report);

/// What has happened to a view: the bits that its STATUS has had in the run.
RegisterValue status_value(int view, const ViewStatistics& count);

}  // namespace trihedron::sim
