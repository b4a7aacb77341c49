// SPDX-License-Identifier: Apache-2.0
#define SC_INCLUDE_DYNAMIC_PROCESSES
#include "sim/testbench.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/register_checks.hpp"

namespace trihedron::sim {
namespace {

// Lines and bursts of records in flight between host side and pins.
constexpr int kFifoDepth = 64;
// Without a transfer on any stream for so long the device hangs. Longer than every gap that a
// source may leave (kMaxGapClocks) and than draining the tallest frame.
constexpr std::uint64_t kHangClocks = 2 * kMaxGapClocks;
// After the last expected record, the streams must stay silent so long.
constexpr std::uint64_t kSilentClocks = 256;

template <typename Fifo>
Fifo* make_fifo(const char* name, std::size_t) {
  return new Fifo(name, kFifoDepth);
}

}  // namespace

Testbench::Testbench(sc_core::sc_module_name name) : sc_module(name) {
  lines_.init(kViews, make_fifo<sc_core::sc_fifo<WireLinePtr>>);
  contour_.init(kViews, make_fifo<sc_core::sc_fifo<ContourLinePtr>>);
  vertices_.init(kViews, make_fifo<sc_core::sc_fifo<VertexBurst>>);
  sources_.init(kViews, [this](const char* source, std::size_t view) {
    return new FrameSourceProcess(source, view, desk_);
  });
  for (std::size_t view = 0; view < kViews; ++view) {
    sources_[view].lines(lines_[view]);
    bench_.lines[view](lines_[view]);
    bench_.contour[view](contour_[view]);
    bench_.vertices[view](vertices_[view]);
    sc_core::sc_spawn_options on_arrival;
    on_arrival.spawn_method();
    on_arrival.dont_initialize();
    on_arrival.set_sensitivity(&contour_[view].data_written_event());
    on_arrival.set_sensitivity(&vertices_[view].data_written_event());
    sc_core::sc_spawn([this, view] { score(view); }, sc_core::sc_gen_unique_name("score"),
                      &on_arrival);
  }
  SC_HAS_PROCESS(Testbench);
  SC_THREAD(conduct);
}

void Testbench::begin(const RunOptions& options) {
  options_ = options;
  report_ = Report{};
  report_.seed = options.seed;
  changes_made_ = 0;
  running_ = true;
  cancelled_ = false;
  begin_.notify(sc_core::SC_ZERO_TIME);
}

bool Testbench::advance() {
  if (!running_) return false;
  sc_core::sc_start();
  if (running_ && finished_frames_.empty() && !desk_.asked()) {
    throw std::logic_error("simulation: every SystemC process waits, none will ever wake");
  }
  return running_;
}

void Testbench::conduct() {
  for (;;) {
    while (!running_) wait(begin_);
    bench_.begin(options_);
    if (configure()) {
      start_views();
      watch();
      collect();
      if (!report_.mismatch && !cancelled_) check_registers();
    }
    stop_views();
    bench_.end();
    running_ = false;
    sc_core::sc_pause();
  }
}

bool Testbench::configure() {
  const auto read = [this](std::uint32_t address) { return bench_.read_register(address); };
  const auto write = [this](std::uint32_t address, std::uint32_t data, unsigned strobe) {
    bench_.write_register(address, data, strobe);
  };
  registers_.emplace(RegisterChecks::Port{read, write}, options_.seed);
  if (options_.exercise_registers) registers_->sweep_after_reset();
  for (const RegisterValue& setting : run_settings(options_)) {
    registers_->set(setting, options_.exercise_registers);
  }
  note(registers_->mismatch());
  note(bench_.violation());
  return !report_.mismatch;
}

// What a frame finds that starts after so many changes: settings that are held do not count yet.
std::vector<SettingsChange> Testbench::settings_in_force() const {
  SettingsChange first;
  first.thresholds = options_.expected_thresholds.value_or(options_.thresholds);
  first.vertex_limit = options_.vertex_limit;
  first.frame_height = options_.frame_height;
  std::vector<SettingsChange> all = {first};
  for (SettingsChange change : options_.changes) {
    if (change.held) {
      change.thresholds = all.back().thresholds;
      change.vertex_limit = all.back().vertex_limit;
      change.frame_height = all.back().frame_height;
    }
    all.push_back(change);
  }
  return all;
}

std::vector<GuardModel::Settings> Testbench::guard_settings(unsigned view) const {
  std::vector<GuardModel::Settings> all;
  const std::vector<SettingsChange> in_force = settings_in_force();
  const std::vector<int> thresholds = first_alike(in_force);
  for (std::size_t i = 0; i < in_force.size(); ++i) {
    const bool enabled = ((in_force[i].enabled >> view) & 1) != 0;
    all.push_back({in_force[i].frame_height, enabled, thresholds[i]});
  }
  return all;
}

void Testbench::start_views() {
  scoreboards_.clear();
  for (int view = 0; view < kViews; ++view) {
    const auto v = static_cast<std::size_t>(view);
    const Scoreboard::Setup setup{view, options_.check, settings_in_force()};
    scoreboards_.emplace_back(setup, [this](FrameResult&& frame) {
      finished_frames_.push_back(std::move(frame));
      sc_core::sc_pause();
    });
    scoreboards_[v].look_up(
        {[this, view](std::size_t start) { return bench_.start_clock(view, start); },
         [this, view](std::size_t start) {
           const std::uint64_t stalls = bench_.input_stalls(view, start);
           bench_.forget_starts(view, start + 1);
           return stalls;
         }});
    const GuardModel guard(guard_settings(static_cast<unsigned>(view)), options_.flush_timeout);
    sources_[v].begin(
        guard, [this, v](ExpectedFrame&& frame) { scoreboards_[v].expect(std::move(frame)); });
  }
  bench_.open_sources();
}

void Testbench::watch() {
  std::uint64_t silent_since = 0, polls = 0;
  while (!over()) {
    wait(bench_.burst_done());
    if (bench_.sources_holding()) change_settings();
    if (options_.poll_registers) registers_->poll(static_cast<int>(polls++ % kViews));
    if (!all_out())
      silent_since = bench_.clocks();
    else if (bench_.clocks() - silent_since >= kSilentClocks)
      return;
  }
}

void Testbench::change_settings() {
  if (changes_made_ < options_.changes.size()) {
    for (const RegisterValue& setting : sim::change_settings(options_.changes[changes_made_])) {
      registers_->set(setting, false);
    }
    ++changes_made_;
  }
  bench_.release_sources();
}

bool Testbench::over() {
  note(bench_.violation());
  note(registers_->mismatch());
  for (const Scoreboard& board : scoreboards_) note(board.mismatch());
  if (!report_.mismatch && bench_.clocks_without_transfer() > kHangClocks) {
    const auto waiting = std::find_if(scoreboards_.begin(), scoreboards_.end(),
                                      [](const Scoreboard& board) { return !board.satisfied(); });
    note((waiting == scoreboards_.end() ? scoreboards_.front() : *waiting).missing());
  }
  return cancelled_ || report_.mismatch;
}

bool Testbench::all_out() const {
  bool out = bench_.sources_finished();
  for (const FrameSourceProcess& source : sources_) out &= source.finished();
  for (const Scoreboard& board : scoreboards_) out &= board.satisfied();
  return out;
}

void Testbench::note(const std::optional<Mismatch>& mismatch) {
  if (!mismatch || report_.mismatch) return;
  report_.mismatch = mismatch;
  report_.mismatch->seed = options_.seed;
  report_.mismatch->clock = bench_.clocks();
}

void Testbench::check_registers() {
  for (const RegisterValue& expected : final_values(options_, report_)) {
    registers_->expect(expected);
  }
  for (int view = 0; view < kViews; ++view) {
    const ViewStatistics& count = report_.views[static_cast<std::size_t>(view)];
    registers_->status(view, status_value(view, count), options_.exercise_registers);
  }
  note(registers_->mismatch());
  note(bench_.violation());
  report_.compared.registers = registers_->compared();
}

void Testbench::collect() {
  bench_.add_statistics(report_);
  for (std::size_t view = 0; view < scoreboards_.size(); ++view) {
    scoreboards_[view].add_to(report_);
    report_.views[view].stream_errors = sources_[view].guard().errors();
    report_.views[view].stream_error_kinds = sources_[view].guard().event_kinds();
  }
}

void Testbench::stop_views() {
  for (FrameSourceProcess& source : sources_) source.stop();
  for (;;) {
    bool finished = true;
    for (const FrameSourceProcess& source : sources_) finished &= source.finished();
    if (finished) break;
    wait(sc_core::SC_ZERO_TIME);
  }
  WireLinePtr line;
  for (auto& fifo : lines_) {
    while (fifo.nb_read(line)) wait(sc_core::SC_ZERO_TIME);
  }
}

void Testbench::score(std::size_t view) {
  ContourLinePtr line;
  VertexBurst burst;
  while (contour_[view].nb_read(line)) scoreboards_[view].take(*line);
  while (vertices_[view].nb_read(burst)) {
    for (const VertexRecord& record : *burst) scoreboards_[view].take(record);
  }
}

}  // namespace trihedron::sim
