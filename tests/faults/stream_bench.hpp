// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "sim/axi_lite_master.hpp"
#include "sim/stimulus.hpp"
#include "sim/stream_driver.hpp"

namespace trihedron::faults {

/// What left one view, beat by beat: for the contour stream the beat with tuser in bit 63 and tlast
/// in bit 62, for the vertex stream the record without its frame tag, tlast in bit 7.
struct ViewOutput {
  std::vector<std::uint64_t> contour;
  std::vector<std::uint64_t> records;
  std::vector<std::uint8_t> tags;  ///< of the records
};

/// A device with drivers and receivers around it that believe anything: broken streams are taken
/// down as they are.
class StreamBench {
 public:
  explicit StreamBench(std::uint64_t seed);

  void send(int view, const sim::SourceFrame& frame);
  /// Runs until nothing has moved for `patience` clocks; `at_clock` is called before each clock.
  void run(std::uint64_t patience, const std::function<void(std::uint64_t clock)>& at_clock);
  /// One register access. Returns false when there was no answer.
  bool access(bool write, std::uint32_t address, std::uint32_t& data);

  sim::Device& device() { return device_; }
  const ViewOutput& output(int view) const { return outputs_[static_cast<std::size_t>(view)]; }
  void forget_output() { outputs_ = {}; }
  /// Starts of frame of `view` accepted so far.
  int starts(int view) const { return starts_[static_cast<std::size_t>(view)]; }
  /// Every pixel was accepted.
  bool all_sent() const;
  std::uint64_t clocks() const { return clocks_; }

 private:
  void reset();
  /// Returns whether anything moved.
  bool clock();

  sim::Device device_;
  std::array<sim::StreamDriver, sim::kViews> drivers_;
  sim::AxiLiteMaster registers_;
  sim::Stall contour_stall_, vertex_stall_;
  std::array<ViewOutput, sim::kViews> outputs_;
  std::array<int, sim::kViews> starts_{};
  std::uint64_t clocks_ = 0;
};

}  // namespace trihedron::faults
