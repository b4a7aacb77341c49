// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"  // before SystemC

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <utility>

#include "sim/axi_lite_master.hpp"
#include "sim/report.hpp"
#include "sim/simulator.hpp"
#include "sim/stream_driver.hpp"
#include "sim/stream_monitor.hpp"

namespace trihedron::sim {

/// Everything at the pins, clock by clock: the Verilated device, three pixel drivers, three
/// contour monitors, the vertex monitor and the register master. One SystemC process runs bursts
/// of clocks and exchanges lines and records with the host side in between; a burst also ends
/// where the host must act, so burst length never shows at the pins.
class PinBench : public sc_core::sc_module {
 public:
  template <typename T>
  using PerView = std::array<T, kViews>;

  sc_core::sc_vector<sc_core::sc_fifo_in<WireLinePtr>> lines{"lines", kViews};
  sc_core::sc_vector<sc_core::sc_fifo_out<ContourLinePtr>> contour{"contour", kViews};
  sc_core::sc_vector<sc_core::sc_fifo_out<VertexBurst>> vertices{"vertices", kViews};

  explicit PinBench(sc_core::sc_module_name name);
  ~PinBench() override;

  /// A fresh device, reset; clocks run from here on. Pixels wait for open_sources().
  void begin(const RunOptions& options);
  void open_sources() { sources_open_ = true; }
  void end();

  /// Register accesses; they take clocks and block the calling SystemC process.
  std::uint32_t read_register(std::uint32_t address) { return access(false, address, 0, 0); }
  void write_register(std::uint32_t address, std::uint32_t data,
                      unsigned strobe = AxiLiteMaster::kAllBytes) {
    access(true, address, data, strobe);
  }

  const sc_core::sc_event& burst_done() const { return burst_done_; }
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t clocks_without_transfer() const { return clocks_ - last_transfer_; }
  bool sources_finished() const;
  /// Every view's driver waits within a line; release() lets them go on.
  bool sources_holding() const;
  void release_sources();
  /// Clock at which frame number `start` of `view` began to be accepted.
  std::uint64_t start_clock(int view, std::size_t start) const;
  /// Input stalls of `view` from that start to the next, or so far.
  std::uint64_t input_stalls(int view, std::size_t start) const;
  void forget_starts(int view, std::size_t before);
  void add_statistics(Report& report) const;
  /// What broke a stream's protocol, where and when.
  const std::optional<Mismatch>& violation() const { return violation_; }

 private:
  struct Pins;  // all pin-level agents of one run

  void reset();
  void run();
  int burst();
  void clock();
  void drive();
  void sample();
  void exchange();
  bool starving() const;
  void violate(int view, const char* stage, const char* rule);
  std::uint32_t access(bool write, std::uint32_t address, std::uint32_t data, unsigned strobe);

  std::unique_ptr<Pins> pins_;
  sc_core::sc_event begin_, wake_, burst_done_, access_done_;
  std::optional<Mismatch> violation_;
  bool running_ = false;
  bool idle_ = true;
  bool sources_open_ = false;
  bool host_needed_ = false;
  bool tracing_ = false;
  std::uint64_t trace_from_clock_ = 0;
  std::uint64_t clocks_ = 0;
  std::uint64_t last_transfer_ = 0;
};

}  // namespace trihedron::sim
