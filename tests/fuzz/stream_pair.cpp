// SPDX-License-Identifier: Apache-2.0
#include "fuzz/stream_pair.hpp"

#include "sim/registers.hpp"
#include "sim/view_pins.hpp"

namespace trihedron::fuzz {
namespace {

constexpr int kResetClocks = 8;
// Without a transfer for so long the device hangs: longer than every gap of a case, and than the
// drain of its frames.
constexpr std::uint64_t kHangClocks = 1 << 17;
// What nobody asked for shows within so many clocks, or within twelve rows of the widest frame: a
// slot is as long as the wider of two widths, and so many rows push the last frame out (row_slots).
constexpr std::uint64_t kSilentClocks = 256 + 12 * static_cast<std::uint64_t>(sim::kMaxWidthPx);

std::vector<sim::SettingsChange> settings_of(const StreamCase& stream_case) {
  std::vector<sim::SettingsChange> all;
  for (const Phase& phase : stream_case.phases) all.push_back(phase.settings);
  return all;
}

}  // namespace

StreamPair::StreamPair(const StreamCase& stream_case)
    : case_(stream_case),
      device_(""),
      vertex_monitor_(case_.options.vertex_stalls, case_.options.seed + 10),
      master_(case_.options.register_stalls, case_.options.seed + 11),
      registers_({[this](std::uint32_t address) { return access(false, address, 0, 0); },
                  [this](std::uint32_t address, std::uint32_t data, unsigned strobe) {
                    access(true, address, data, strobe);
                  }},
                 case_.options.seed) {
  for (unsigned view = 0; view < sim::kViews; ++view) {
    drivers_.emplace_back(case_.options.pixel_idles, case_.options.seed + view);
    monitors_.emplace_back(case_.options.contour_stalls, case_.options.seed + 5 + view);
    std::vector<sim::GuardModel::Settings> settings;
    const std::vector<int> thresholds = sim::first_alike(settings_of(case_));
    for (std::size_t i = 0; i < case_.phases.size(); ++i) {
      const sim::SettingsChange& change = case_.phases[i].settings;
      const bool enabled = ((change.enabled >> view) & 1) != 0;
      settings.push_back({change.frame_height, enabled, thresholds[i]});
    }
    guards_.emplace_back(settings, case_.options.flush_timeout);
    const sim::Scoreboard::Setup setup{static_cast<int>(view), true, settings_of(case_)};
    scoreboards_.emplace_back(setup, [](sim::FrameResult&&) {});
    scoreboards_.back().look_up({[this, view](std::size_t i) { return start_clocks_[view].at(i); },
                                 [](std::size_t) { return std::uint64_t{0}; }});
  }
  announce();
}

// The models go through the whole case before the device does.
void StreamPair::announce() {
  for (std::size_t view = 0; view < sim::kViews; ++view) {
    std::vector<sim::ExpectedFrame> expected;
    for (const Phase& phase : case_.phases) {
      for (std::size_t i = 0; i < phase.lines[view].size(); ++i) {
        sim::WireLine line = phase.lines[view][i];
        line.hold = i + 1 == phase.lines[view].size();  // the next phase has the next settings
        guards_[view].feed(line, expected);
      }
      guards_[view].finish(expected);
    }
    for (sim::ExpectedFrame& frame : expected) scoreboards_[view].expect(std::move(frame));
  }
}

std::string StreamPair::run() {
  reset();
  registers_.set(sim::run_settings(case_.options).back(), false);  // FLUSH_TIMEOUT
  for (const Phase& phase : case_.phases) {
    for (const sim::RegisterValue& setting : sim::change_settings(phase.settings))
      registers_.set(setting, false);
    if (difference_.empty()) play(phase);
  }
  if (difference_.empty()) {
    for (const sim::Scoreboard& board : scoreboards_)
      if (!board.satisfied()) note(board.missing());
  }
  if (difference_.empty()) check_registers();
  note(registers_.mismatch());
  return difference_;
}

void StreamPair::reset() {
  device_.pins().rst_ni = 0;
  for (int i = 0; i < kResetClocks; ++i) {
    device_.settle();
    device_.tick();
  }
  device_.pins().rst_ni = 1;
}

void StreamPair::play(const Phase& phase) {
  for (std::size_t view = 0; view < sim::kViews; ++view)
    for (const sim::WireLine& line : phase.lines[view])
      drivers_[view].queue(std::make_shared<const sim::WireLine>(line));
  last_transfer_ = clocks_;
  while (difference_.empty() && !quiet()) {
    clock();
    sort_out();
  }
}

// Everything was sent, and nothing has moved for longer than what is left can take.
bool StreamPair::quiet() const {
  for (const sim::StreamDriver& driver : drivers_)
    if (!driver.starving()) return clocks_ - last_transfer_ > kHangClocks;
  return clocks_ - last_transfer_ >
         kSilentClocks + 2 * static_cast<std::uint64_t>(case_.options.flush_timeout);
}

void StreamPair::clock() {
  drive();
  device_.settle();
  sample();
  device_.tick();
  if (device_.failed()) note("an assertion of the RTL failed");
  ++clocks_;
}

void StreamPair::drive() {
  Vtrihedron_top& top = device_.pins();
  sim::present_video(drivers_, top);
  top.m_axis_contour_tready =
      sim::view_bits([this](unsigned view) { return monitors_[view].ready(); });
  top.m_axis_vertex_tready = vertex_monitor_.ready();
  master_.present(top);
}

void StreamPair::sample() {
  const Vtrihedron_top& top = device_.pins();
  bool moved = top.m_axis_vertex_tvalid && top.m_axis_vertex_tready;
  for (unsigned view = 0; view < sim::kViews; ++view) {
    if (drivers_[view].valid() && ((top.s_axis_tready >> view) & 1)) {
      if (drivers_[view].accept()) start_clocks_[view].push_back(clocks_);
      moved = true;
    }
    const bool valid = (top.m_axis_contour_tvalid >> view) & 1;
    moved |= valid && ((top.m_axis_contour_tready >> view) & 1);
    const std::uint64_t beat = top.m_axis_contour_tdata[2 * view] |
                               std::uint64_t{top.m_axis_contour_tdata[2 * view + 1]} << 32;
    if (!monitors_[view].sample(valid, beat, (top.m_axis_contour_tuser >> view) & 1,
                                (top.m_axis_contour_tlast >> view) & 1, clocks_))
      note("a stalled contour beat changed");
  }
  if (!vertex_monitor_.sample(top.m_axis_vertex_tvalid, top.m_axis_vertex_tdata,
                              top.m_axis_vertex_tlast))
    note("a stalled vertex record changed, or names no view");
  master_.accept(top);
  if (moved) last_transfer_ = clocks_;
}

void StreamPair::sort_out() {
  for (std::size_t view = 0; view < sim::kViews; ++view) {
    for (const sim::ContourLinePtr& line : monitors_[view].take_lines())
      scoreboards_[view].take(*line);
    for (const sim::VertexRecord& record : vertex_monitor_.take_records(static_cast<int>(view)))
      scoreboards_[view].take(record);
    note(scoreboards_[view].mismatch());
  }
}

std::uint32_t StreamPair::access(bool write, std::uint32_t address, std::uint32_t data,
                                 unsigned strobe) {
  master_.start(write, address, data, strobe);
  const std::uint64_t start = clocks_;
  while (master_.busy() && difference_.empty()) {
    clock();
    if (clocks_ - start > kHangClocks) note("a register access without an answer");
  }
  return master_.data();
}

void StreamPair::check_registers() {
  sim::Report report;
  sim::RunOptions options = case_.options;
  options.changes = {case_.phases.back().settings};
  for (std::size_t view = 0; view < sim::kViews; ++view) {
    scoreboards_[view].add_to(report);
    report.views[view].stream_errors = guards_[view].errors();
    report.views[view].stream_error_kinds = guards_[view].event_kinds();
  }
  if (report.compared.beats == 0 && options.changes.back().enabled != 0)
    note("nothing was compared");
  for (const sim::RegisterValue& value : sim::final_values(options, report))
    registers_.expect(value);
  for (int view = 0; view < sim::kViews; ++view)
    registers_.status(view, sim::status_value(view, report.views[static_cast<std::size_t>(view)]),
                      true);
}

void StreamPair::note(const std::string& what) {
  if (difference_.empty()) difference_ = what + " (clock " + std::to_string(clocks_) + ")";
}

void StreamPair::note(const std::optional<sim::Mismatch>& mismatch) {
  if (mismatch) note(mismatch->text());
}

}  // namespace trihedron::fuzz
