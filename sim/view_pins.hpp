// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"
#include "sim/stimulus.hpp"
#include "sim/stream_driver.hpp"

namespace trihedron::sim {

/// One bit per view, view 0 in bit 0: what `bit(view)` says.
template <typename Bit>
CData view_bits(const Bit& bit) {
  unsigned bits = 0;
  for (unsigned view = 0; view < kViews; ++view) bits |= static_cast<unsigned>(bit(view)) << view;
  return static_cast<CData>(bits);
}

/// Lets the video sources decide about this clock and puts them on the pins.
template <typename Drivers>
void present_video(Drivers& drivers, Vtrihedron_top& top) {
  unsigned data = 0;
  for (unsigned view = 0; view < kViews; ++view) {
    drivers[view].present();
    data |= static_cast<unsigned>(drivers[view].data()) << (8 * view);
  }
  top.s_axis_tdata = data;
  top.s_axis_tvalid = view_bits([&](unsigned view) { return drivers[view].valid(); });
  top.s_axis_tuser = view_bits([&](unsigned view) { return drivers[view].user(); });
  top.s_axis_tlast = view_bits([&](unsigned view) { return drivers[view].last(); });
}

}  // namespace trihedron::sim
