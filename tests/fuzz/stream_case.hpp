// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/simulator.hpp"
#include "sim/wire_line.hpp"

namespace trihedron::fuzz {

/// Lines for each view, sent after `settings` were written. Ends with one good frame per view, so
/// that every frame before it has ended.
struct Phase {
  sim::SettingsChange settings;
  std::array<std::vector<sim::WireLine>, sim::kViews> lines;
};

/// What any bytes say is sent into the device, and how its streams stall.
struct StreamCase {
  sim::RunOptions options;
  std::vector<Phase> phases;
};

/// Every input is a case; a longer one goes on where a shorter one ends.
StreamCase decode_case(const std::uint8_t* data, std::size_t size);

}  // namespace trihedron::fuzz
