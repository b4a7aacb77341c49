// SPDX-License-Identifier: Apache-2.0
#pragma once

// Verilator's headers go before SystemC's.
#include <verilated.h>
#include <verilated_fst_c.h>

#include <cstdint>
#include <memory>
#include <string>

#include "Vtrihedron_top.h"

namespace trihedron::sim {

/// The Verilated top and its clock: settle() lets the inputs reach the outputs, tick() is the
/// rising edge. 10 ns a clock in the waveform.
class Device {
 public:
  /// A device in the state before reset; writes every clock to `trace_file` unless empty.
  explicit Device(const std::string& trace_file) {
    context_.traceEverOn(!trace_file.empty());
    top_ = std::make_unique<Vtrihedron_top>(&context_, "trihedron_top");
    if (trace_file.empty()) return;
    trace_ = std::make_unique<VerilatedFstC>();
    top_->trace(trace_.get(), kAllLevels);
    trace_->open(trace_file.c_str());
  }
  ~Device() {
    top_->final();
    if (trace_) trace_->close();
  }

  Vtrihedron_top& pins() { return *top_; }

  void settle() {
    top_->clk_i = 0;
    top_->eval();
    if (trace_) trace_->dump(kClockPs * clocks_);
  }
  void tick() {
    top_->clk_i = 1;
    top_->eval();
    if (trace_) trace_->dump(kClockPs * clocks_ + kClockPs / 2);
    ++clocks_;
  }

 private:
  static constexpr int kAllLevels = 99;
  static constexpr std::uint64_t kClockPs = 10000;

  VerilatedContext context_;
  std::unique_ptr<Vtrihedron_top> top_;
  std::unique_ptr<VerilatedFstC> trace_;
  std::uint64_t clocks_ = 0;
};

}  // namespace trihedron::sim
