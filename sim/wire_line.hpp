// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// One line of pixels as it goes over a pixel stream: the transaction between the frame source
/// and the driver. A line without `end` runs into the next one.
struct WireLine {
  std::vector<std::uint8_t> pixels;
  bool start = false;    ///< tuser at the first pixel
  int stray_start = -1;  ///< column with a tuser that does not belong there, or -1
  bool end = true;       ///< tlast at the last pixel
  bool hold = false;     ///< waits before the fourth pixel until it is released
  int gap_clocks = 0;    ///< idle clocks before the first pixel
};
using WireLinePtr = std::shared_ptr<const WireLine>;

/// The lines that carry `frame`, its fault included.
std::vector<WireLinePtr> make_wire_lines(const SourceFrame& frame);

}  // namespace trihedron::sim
