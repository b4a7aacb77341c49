// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/stream_case.hpp"
#include "sim/axi_lite_master.hpp"
#include "sim/register_checks.hpp"
#include "sim/scoreboard.hpp"
#include "sim/stream_driver.hpp"
#include "sim/stream_monitor.hpp"

namespace trihedron::fuzz {

/// The device and the models beside it, without SystemC: what goes in is given line by line and
/// need not be frames.
class StreamPair {
 public:
  explicit StreamPair(const StreamCase& stream_case);

  /// Sends everything. Returns the first difference, "" when all was equal.
  std::string run();

 private:
  template <typename T>
  using PerView = std::array<T, sim::kViews>;

  void reset();
  void announce();
  void clock();
  void drive();
  void sample();
  void sort_out();
  void play(const Phase& phase);
  bool quiet() const;
  std::uint32_t access(bool write, std::uint32_t address, std::uint32_t data, unsigned strobe);
  void check_registers();
  void note(const std::string& what);
  void note(const std::optional<sim::Mismatch>& mismatch);

  const StreamCase& case_;
  sim::Device device_;
  std::vector<sim::StreamDriver> drivers_;
  std::vector<sim::ContourMonitor> monitors_;
  sim::VertexMonitor vertex_monitor_;
  sim::AxiLiteMaster master_;
  sim::RegisterChecks registers_;
  std::vector<sim::GuardModel> guards_;
  std::vector<sim::Scoreboard> scoreboards_;
  PerView<std::vector<std::uint64_t>> start_clocks_;
  std::uint64_t clocks_ = 0, last_transfer_ = 0;
  std::string difference_;
};

}  // namespace trihedron::fuzz
