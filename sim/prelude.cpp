// SPDX-License-Identifier: Apache-2.0
#include "sim/prelude.hpp"

#include <array>
#include <iterator>

#include "golden/registers.hpp"
#include "sim/axi_lite_master.hpp"
#include "sim/pattern.hpp"
#include "sim/stream_driver.hpp"

namespace trihedron::sim {
namespace {

constexpr StallProfile kStalls{0.2, 8};

std::array<StreamDriver, kViews> make_drivers(Random& random) {
  return {StreamDriver(kStalls, random.next()), StreamDriver(kStalls, random.next()),
          StreamDriver(kStalls, random.next())};
}

void keep_fed(StreamDriver& driver, Random& random) {
  if (!driver.wants_lines()) return;
  SourceFrame frame;
  frame.image = make_image(Pattern::kNoise, random.between(kMinSizePx, 40),
                           random.between(kMinSizePx, 30), random, {});
  for (const WireLinePtr& line : make_wire_lines(frame)) driver.queue(line);
}

void write_something(AxiLiteMaster& registers, Random& random) {
  const int last = static_cast<int>(std::size(registers::kRegisters)) - 1;
  const registers::Register& target =
      registers::kRegisters[static_cast<std::size_t>(random.between(0, last))];
  registers.start(true, target.address, static_cast<std::uint32_t>(random.next()));
}

}  // namespace

void play_prelude(Device& device, std::uint64_t seed, int clocks) {
  Random random(seed);
  Vtrihedron_top& top = device.pins();
  std::array<StreamDriver, kViews> drivers = make_drivers(random);
  AxiLiteMaster registers(kStalls, random.next());
  for (int clock = 0; clock < clocks; ++clock) {
    unsigned data = 0, valid = 0, user = 0, last = 0;
    for (unsigned view = 0; view < kViews; ++view) {
      StreamDriver& driver = drivers[view];
      keep_fed(driver, random);
      driver.present();
      data |= static_cast<unsigned>(driver.data()) << (8 * view);
      valid |= static_cast<unsigned>(driver.valid()) << view;
      user |= static_cast<unsigned>(driver.user()) << view;
      last |= static_cast<unsigned>(driver.last()) << view;
    }
    top.s_axis_tdata = data;
    top.s_axis_tvalid = static_cast<CData>(valid);
    top.s_axis_tuser = static_cast<CData>(user);
    top.s_axis_tlast = static_cast<CData>(last);
    top.m_axis_contour_tready = static_cast<CData>(random.next() & kAllViews);
    top.m_axis_vertex_tready = random.chance(0.7);
    if (!registers.busy() && random.chance(0.02)) write_something(registers, random);
    registers.present(top);
    device.settle();
    for (unsigned view = 0; view < kViews; ++view) {
      if (drivers[view].valid() && ((top.s_axis_tready >> view) & 1)) drivers[view].accept();
    }
    registers.accept(top);
    device.tick();
  }
  top.s_axis_tvalid = 0;
  top.s_axil_awvalid = top.s_axil_wvalid = top.s_axil_arvalid = 0;
}

}  // namespace trihedron::sim
