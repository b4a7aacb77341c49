// SPDX-License-Identifier: Apache-2.0
#include "sim/pin_bench.hpp"

#include <deque>

#include "sim/prelude.hpp"
#include "sim/view_pins.hpp"

namespace trihedron::sim {
namespace {

// Clocks between two host exchanges when nobody asks for one earlier: a context switch and the
// hand-over of a few lines cost less than 1 % of simulating so many clocks.
constexpr int kBurstClocks = 1024;
constexpr int kResetClocks = 8;
// A register access ends within a few clocks and the master's own stalls (bursts of 64).
constexpr std::uint64_t kAnswerClocks = 16384;
const sc_core::sc_time kClockPeriod(10, sc_core::SC_NS);

// Independent random streams for each stalling agent of a run.
std::uint64_t agent_seed(std::uint64_t seed, int agent) {
  return Random(seed * 64 + static_cast<std::uint64_t>(agent)).next();
}

}  // namespace

struct PinBench::Pins {
  explicit Pins(const RunOptions& options)
      : device(options.trace_file, options.code_coverage_file),
        drivers{driver(options, 0), driver(options, 1), driver(options, 2)},
        monitors{monitor(options, 0), monitor(options, 1), monitor(options, 2)},
        vertex_monitor(options.vertex_stalls, agent_seed(options.seed, 32)),
        registers(options.register_stalls, agent_seed(options.seed, 33)) {}

  static StreamDriver driver(const RunOptions& options, int view) {
    return StreamDriver(options.pixel_idles, agent_seed(options.seed, view));
  }
  static ContourMonitor monitor(const RunOptions& options, int view) {
    return ContourMonitor(options.contour_stalls, agent_seed(options.seed, 16 + view));
  }

  Device device;
  PerView<StreamDriver> drivers;
  PerView<ContourMonitor> monitors;
  VertexMonitor vertex_monitor;
  AxiLiteMaster registers;
  // Clock of accepted frame starts and input stalls before them, oldest first, and how many were
  // forgotten.
  struct Start {
    std::uint64_t clock = 0, stalls = 0;
  };
  PerView<std::deque<Start>> starts;
  PerView<std::size_t> starts_forgotten{};
  PerView<ViewStatistics> statistics{};
};

PinBench::PinBench(sc_core::sc_module_name name) : sc_module(name) {
  SC_HAS_PROCESS(PinBench);
  SC_THREAD(run);
}

PinBench::~PinBench() = default;

void PinBench::begin(const RunOptions& options) {
  pins_ = std::make_unique<Pins>(options);
  violation_.reset();
  clocks_ = last_transfer_ = 0;
  sources_open_ = false;
  tracing_ = !options.trace_file.empty();
  trace_from_clock_ = options.trace_from_clock;
  pins_->device.record(trace_from_clock_ == 0);
  reset();
  if (options.prelude_clocks > 0) {
    play_prelude(pins_->device, agent_seed(options.seed, 34), options.prelude_clocks);
    reset();
  }
  running_ = true;
  begin_.notify();
}

void PinBench::reset() {
  Vtrihedron_top& top = pins_->device.pins();
  top.rst_ni = 0;
  for (int clock = 0; clock < kResetClocks; ++clock) {
    pins_->device.settle();
    pins_->device.tick();
  }
  top.rst_ni = 1;
}

void PinBench::end() {
  running_ = false;
  wake_.notify(sc_core::SC_ZERO_TIME);
  while (!idle_) wait(burst_done_);
  pins_.reset();
}

void PinBench::run() {
  for (;;) {
    while (!running_) wait(begin_);
    idle_ = false;
    while (running_) {
      const int clocks = burst();
      wait(clocks * kClockPeriod);
      exchange();
      while (running_ && starving()) {
        wait(lines[0].data_written_event() | lines[1].data_written_event() |
             lines[2].data_written_event() | wake_);
        exchange();
      }
      burst_done_.notify(sc_core::SC_ZERO_TIME);
    }
    idle_ = true;
    burst_done_.notify(sc_core::SC_ZERO_TIME);
  }
}

int PinBench::burst() {
  host_needed_ = false;
  int clocks = 0;
  while (clocks < kBurstClocks && !host_needed_) {
    clock();
    ++clocks;
  }
  return clocks;
}

void PinBench::clock() {
  Device& device = pins_->device;
  if (tracing_) device.record(clocks_ >= trace_from_clock_);
  drive();
  device.settle();
  sample();
  device.tick();
  if (device.failed()) violate(0, "RTL assertion", "it to hold (its text is printed above)");
  ++clocks_;
}

void PinBench::drive() {
  Vtrihedron_top& top = pins_->device.pins();
  present_video(pins_->drivers, top);
  top.m_axis_contour_tready =
      view_bits([this](unsigned view) { return pins_->monitors[view].ready(); });
  top.m_axis_vertex_tready = pins_->vertex_monitor.ready();
  pins_->registers.present(top);
}

void PinBench::sample() {
  const Vtrihedron_top& top = pins_->device.pins();
  bool transfer = top.m_axis_vertex_tvalid && top.m_axis_vertex_tready;
  for (unsigned view = 0; view < kViews; ++view) {
    StreamDriver& driver = pins_->drivers[view];
    ViewStatistics& count = pins_->statistics[view];
    if (!driver.valid()) {
      count.input_idles += sources_open_ && !driver.finished();
    } else if ((top.s_axis_tready >> view) & 1) {
      transfer = true;
      ++count.pixels;
      if (driver.accept()) pins_->starts[view].push_back({clocks_, count.input_stalls});
      host_needed_ |= driver.starving() || driver.holding();
    } else {
      ++count.input_stalls;
    }
    const bool valid = (top.m_axis_contour_tvalid >> view) & 1;
    const std::uint64_t beat = top.m_axis_contour_tdata[2 * view] |
                               static_cast<std::uint64_t>(top.m_axis_contour_tdata[2 * view + 1])
                                   << 32;
    transfer |= valid && ((top.m_axis_contour_tready >> view) & 1);
    if (!pins_->monitors[view].sample(valid, beat, (top.m_axis_contour_tuser >> view) & 1,
                                      (top.m_axis_contour_tlast >> view) & 1, clocks_)) {
      violate(static_cast<int>(view), "contour stream", "a stalled beat to stay as it is");
    }
  }
  if (!pins_->vertex_monitor.sample(top.m_axis_vertex_tvalid, top.m_axis_vertex_tdata,
                                    top.m_axis_vertex_tlast)) {
    violate(0, "vertex stream", "a stalled record to stay as it is and a known view");
  }
  if (pins_->registers.accept(top)) {
    access_done_.notify(sc_core::SC_ZERO_TIME);
    host_needed_ = true;
  }
  if (transfer) last_transfer_ = clocks_;
}

void PinBench::exchange() {
  for (int view = 0; view < kViews; ++view) {
    const auto v = static_cast<std::size_t>(view);
    for (ContourLinePtr& line : pins_->monitors[v].take_lines()) contour[v].write(line);
    auto records = pins_->vertex_monitor.take_records(view);
    if (!records.empty()) {
      vertices[v].write(std::make_shared<const std::vector<VertexRecord>>(std::move(records)));
    }
    if (!sources_open_) continue;
    WireLinePtr line;
    while (pins_->drivers[v].wants_lines() && lines[v].nb_read(line)) {
      if (line)
        pins_->drivers[v].queue(std::move(line));
      else
        pins_->drivers[v].close();
    }
  }
}

bool PinBench::starving() const {
  if (!sources_open_) return false;
  for (const StreamDriver& driver : pins_->drivers) {
    if (driver.starving()) return true;
  }
  return false;
}

bool PinBench::sources_finished() const {
  for (const StreamDriver& driver : pins_->drivers) {
    if (!driver.finished()) return false;
  }
  return true;
}

bool PinBench::sources_holding() const {
  for (const StreamDriver& driver : pins_->drivers) {
    if (!driver.holding()) return false;
  }
  return true;
}

void PinBench::release_sources() {
  for (StreamDriver& driver : pins_->drivers) driver.release();
}

void PinBench::violate(int view, const char* stage, const char* rule) {
  host_needed_ = true;
  if (violation_) return;
  violation_ = Mismatch{};
  violation_->view = view;
  violation_->stage = stage;
  violation_->expected = rule;
  violation_->got = "something else";
  violation_->clock = clocks_;
}

std::uint32_t PinBench::access(bool write, std::uint32_t address, std::uint32_t data,
                               unsigned strobe) {
  if (violation_) return 0;
  const std::uint64_t start = clocks_;
  pins_->registers.start(write, address, data, strobe);
  while (pins_->registers.busy() && !violation_) {
    wait(access_done_ | burst_done_);
    if (clocks_ - start > kAnswerClocks) violate(0, "register access", "an answer");
  }
  return pins_->registers.data();
}

std::uint64_t PinBench::start_clock(int view, std::size_t start) const {
  const auto v = static_cast<std::size_t>(view);
  return pins_->starts[v].at(start - pins_->starts_forgotten[v]).clock;
}

std::uint64_t PinBench::input_stalls(int view, std::size_t start) const {
  const auto v = static_cast<std::size_t>(view);
  const auto& starts = pins_->starts[v];
  const std::size_t at = start - pins_->starts_forgotten[v];
  const std::uint64_t end =
      at + 1 < starts.size() ? starts[at + 1].stalls : pins_->statistics[v].input_stalls;
  return end - starts.at(at).stalls;
}

void PinBench::forget_starts(int view, std::size_t before) {
  const auto v = static_cast<std::size_t>(view);
  while (pins_->starts_forgotten[v] < before && !pins_->starts[v].empty()) {
    pins_->starts[v].pop_front();
    ++pins_->starts_forgotten[v];
  }
}

void PinBench::add_statistics(Report& report) const {
  report.clocks = clocks_;
  for (std::size_t v = 0; v < kViews; ++v) {
    ViewStatistics& total = report.views[v];
    total.pixels = pins_->statistics[v].pixels;
    total.input_stalls = pins_->statistics[v].input_stalls;
    total.input_idles = pins_->statistics[v].input_idles;
    total.contour_beats = pins_->monitors[v].beats();
    total.contour_stalls = pins_->monitors[v].stalls();
  }
}

}  // namespace trihedron::sim
