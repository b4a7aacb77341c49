// SPDX-License-Identifier: Apache-2.0
#pragma once

// Verilator's headers go before SystemC's.
#include <verilated.h>
#include <verilated_fst_c.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "Vtrihedron_top.h"
#ifdef TRIHEDRON_RTL_COVERAGE
#include <verilated_cov.h>

#include <algorithm>
#include <iterator>

#include "Vtrihedron_top__Syms.h"
#include "Vtrihedron_top___024root.h"
#endif

namespace trihedron::sim {

/// The Verilated top and its clock: settle() lets the inputs reach the outputs, tick() is the
/// rising edge. 10 ns a clock in the waveform, counted from power-on.
class Device {
#ifdef TRIHEDRON_RTL_COVERAGE
  // Verilator counts in an array of the model; a new device goes on where the last one stopped.
  auto& coverage_counters() { return top_->rootp->vlSymsp->__Vcoverage; }
  std::vector<std::uint32_t>& coverage_total() {
    static std::vector<std::uint32_t> total(std::size(coverage_counters()), 0);
    return total;
  }
  void save_coverage() {
    std::copy(std::begin(coverage_counters()), std::end(coverage_counters()),
              coverage_total().begin());
    if (!coverage_file_.empty()) context_.coveragep()->write(coverage_file_.c_str());
  }
#endif

 public:
  /// A device in the state before reset; writes every clock to `trace_file` unless empty, and the
  /// coverage of all devices of this process to `coverage_file`.
  explicit Device(const std::string& trace_file, const std::string& coverage_file = "")
      : coverage_file_(coverage_file) {
    context_.traceEverOn(!trace_file.empty());
    context_.fatalOnError(false);  // a failed assertion is the caller's to report
    top_ = std::make_unique<Vtrihedron_top>(&context_, "trihedron_top");
#ifdef TRIHEDRON_RTL_COVERAGE
    std::copy(coverage_total().begin(), coverage_total().end(), std::begin(coverage_counters()));
#endif
    if (trace_file.empty()) return;
    trace_ = std::make_unique<VerilatedFstC>();
    top_->trace(trace_.get(), kAllLevels);
    trace_->open(trace_file.c_str());
  }
  ~Device() {
    top_->final();
    if (trace_) trace_->close();
#ifdef TRIHEDRON_RTL_COVERAGE
    save_coverage();
#endif
  }

  Vtrihedron_top& pins() { return *top_; }
  VerilatedContext& context() { return context_; }

  /// An assertion of the RTL has failed; Verilator has printed which.
  bool failed() const { return context_.gotError(); }
  /// Whether clocks go into the waveform from here on.
  void record(bool on) { recording_ = on; }

  void settle() {
    top_->clk_i = 0;
    top_->eval();
    if (trace_ && recording_) trace_->dump(kClockPs * clocks_);
  }
  void tick() {
    top_->clk_i = 1;
    top_->eval();
    if (trace_ && recording_) trace_->dump(kClockPs * clocks_ + kClockPs / 2);
    ++clocks_;
  }

 private:
  static constexpr int kAllLevels = 99;
  static constexpr std::uint64_t kClockPs = 10000;

  std::string coverage_file_;
  VerilatedContext context_;
  std::unique_ptr<Vtrihedron_top> top_;
  std::unique_ptr<VerilatedFstC> trace_;
  std::uint64_t clocks_ = 0;
  bool recording_ = true;
};

}  // namespace trihedron::sim
