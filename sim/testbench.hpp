// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/pin_bench.hpp"  // Verilated headers before SystemC's

#include <optional>
#include <systemc>
#include <vector>

#include "sim/frame_source.hpp"
#include "sim/register_checks.hpp"
#include "sim/scoreboard.hpp"
#include "sim/simulator.hpp"

namespace trihedron::sim {

/// The SystemC side of the simulator: sources and scoreboards around the pin bench, and the
/// process that conducts a run from reset to the last register check.
class Testbench : public sc_core::sc_module {
 public:
  explicit Testbench(sc_core::sc_module_name name);

  /// Starts a run; then call advance() until it returns false.
  void begin(const RunOptions& options);
  /// Simulates until a source is to be served, frames wait to be taken, or the run is over.
  bool advance();
  void serve(const FrameSource& source) { desk_.serve(source); }
  std::vector<FrameResult> take_frames() { return std::exchange(finished_frames_, {}); }
  /// Ends the run early.
  void cancel() { cancelled_ = true; }
  const Report& report() const { return report_; }

 private:
  template <typename T>
  using Fifos = sc_core::sc_vector<sc_core::sc_fifo<T>>;

  void conduct();
  bool configure();
  void start_views();
  void watch();
  void change_settings();
  void stop_views();
  void check_registers();
  std::vector<SettingsChange> settings_in_force() const;
  std::vector<GuardModel::Settings> guard_settings(unsigned view) const;
  void collect();
  void score(std::size_t view);
  bool all_out() const;
  bool over();
  void note(const std::optional<Mismatch>& mismatch);

  PinBench bench_{"bench"};
  FrameDesk desk_;
  sc_core::sc_vector<FrameSourceProcess> sources_{"sources"};
  Fifos<WireLinePtr> lines_{"lines"};
  Fifos<ContourLinePtr> contour_{"contour"};
  Fifos<VertexBurst> vertices_{"vertices"};
  std::vector<Scoreboard> scoreboards_;
  std::optional<RegisterChecks> registers_;
  sc_core::sc_event begin_;
  RunOptions options_;
  Report report_;
  std::vector<FrameResult> finished_frames_;
  std::size_t changes_made_ = 0;
  bool running_ = false;
  bool cancelled_ = false;
};

}  // namespace trihedron::sim
