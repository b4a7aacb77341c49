// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"

#include <cstdint>
#include <initializer_list>

#include "sim/axi_lite_master.hpp"

namespace trihedron::driver {

/// The simulated top with a master at its registers; pixels reach view 0 only, outputs are drained.
class DrivenDevice {
 public:
  /// After a reset.
  DrivenDevice();

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);

  /// A line of `width` equal pixels into view 0.
  void send_line(int width, bool start_of_frame);
  void wait(int clocks);

 private:
  void clock();
  std::uint32_t access(bool write, std::uint32_t address, std::uint32_t value);

  sim::Device device_;
  sim::AxiLiteMaster master_;
};

/// The device that trihedron_read() and trihedron_write() of the C driver reach.
extern DrivenDevice* g_bus;

}  // namespace trihedron::driver
