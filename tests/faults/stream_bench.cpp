// SPDX-License-Identifier: Apache-2.0
#include "faults/stream_bench.hpp"

#include "sim/random.hpp"
#include "sim/view_pins.hpp"

namespace trihedron::faults {
namespace {

constexpr int kResetClocks = 4;
constexpr int kAnswerClocks = 100;

sim::StallProfile light_stalls(std::uint64_t seed) {
  return seed % 2 == 0 ? sim::StallProfile{0.1, 4} : sim::StallProfile{};
}

}  // namespace

StreamBench::StreamBench(std::uint64_t seed)
    : device_(""),
      drivers_{sim::StreamDriver(light_stalls(seed), seed),
               sim::StreamDriver(light_stalls(seed), seed + 1),
               sim::StreamDriver(light_stalls(seed), seed + 2)},
      registers_({}, seed),
      contour_stall_(light_stalls(seed / 2), seed + 3),
      vertex_stall_(light_stalls(seed / 2), seed + 4) {
  device_.context().assertOn(false);  // an upset may break what they say; the streams decide
  reset();
}

void StreamBench::reset() {
  device_.pins().rst_ni = 0;
  for (int i = 0; i < kResetClocks; ++i) {
    device_.settle();
    device_.tick();
  }
  device_.pins().rst_ni = 1;
}

void StreamBench::send(int view, const sim::SourceFrame& frame) {
  for (sim::WireLinePtr& line : sim::make_wire_lines(frame)) {
    drivers_[static_cast<std::size_t>(view)].queue(std::move(line));
  }
}

bool StreamBench::all_sent() const {
  for (const sim::StreamDriver& driver : drivers_) {
    if (!driver.starving()) return false;
  }
  return true;
}

bool StreamBench::clock() {
  Vtrihedron_top& top = device_.pins();
  sim::present_video(drivers_, top);
  const unsigned ready =
      sim::view_bits([this](unsigned) { return !contour_stall_.at_this_clock(); });
  top.m_axis_contour_tready = static_cast<CData>(ready);
  top.m_axis_vertex_tready = !vertex_stall_.at_this_clock();
  registers_.present(top);
  device_.settle();
  bool moved = false;
  for (unsigned view = 0; view < sim::kViews; ++view) {
    if (drivers_[view].valid() && ((top.s_axis_tready >> view) & 1)) {
      starts_[view] += drivers_[view].accept();
      moved = true;
    }
    if (((top.m_axis_contour_tvalid & ready) >> view) & 1) {
      const auto flag = [view](unsigned bits) { return std::uint64_t{(bits >> view) & 1}; };
      outputs_[view].contour.push_back(top.m_axis_contour_tdata[2 * view] |
                                       std::uint64_t{top.m_axis_contour_tdata[2 * view + 1]} << 32 |
                                       flag(top.m_axis_contour_tuser) << 63 |
                                       flag(top.m_axis_contour_tlast) << 62);
      moved = true;
    }
  }
  if (top.m_axis_vertex_tvalid && top.m_axis_vertex_tready) {
    const std::uint64_t record = top.m_axis_vertex_tdata;
    ViewOutput& output = outputs_[(record >> 2) % 4 % sim::kViews];
    output.records.push_back((record & ~std::uint64_t{0xff00}) |
                             std::uint64_t{top.m_axis_vertex_tlast} << 7);
    output.tags.push_back(static_cast<std::uint8_t>(record >> 8));
    moved = true;
  }
  registers_.accept(top);
  device_.tick();
  ++clocks_;
  return moved;
}

void StreamBench::run(std::uint64_t patience,
                      const std::function<void(std::uint64_t clock)>& at_clock) {
  for (std::uint64_t still = 0; still < patience;) {
    if (at_clock) at_clock(clocks_);
    still = clock() ? 0 : still + 1;
  }
}

bool StreamBench::access(bool write, std::uint32_t address, std::uint32_t& data) {
  if (registers_.busy()) return false;
  registers_.start(write, address, data);
  for (int i = 0; i < kAnswerClocks && registers_.busy(); ++i) clock();
  data = registers_.data();
  return !registers_.busy();
}

}  // namespace trihedron::faults
