// SPDX-License-Identifier: Apache-2.0
#include "driver/driven_device.hpp"

#include <catch2/catch.hpp>

extern "C" {
#include "trihedron.h"
}

namespace trihedron::driver {
namespace {

constexpr int kResetClocks = 4;
constexpr int kAnswerClocks = 100;    // more than any access takes
constexpr int kAcceptClocks = 10000;  // more than the pipeline ever blocks its input

}  // namespace

DrivenDevice* g_bus = nullptr;

DrivenDevice::DrivenDevice() : device_(""), master_({}, 1) {
  device_.pins().rst_ni = 0;
  wait(kResetClocks);
  device_.pins().rst_ni = 1;
}

void DrivenDevice::clock() {
  Vtrihedron_top& top = device_.pins();
  top.m_axis_contour_tready = 7;
  top.m_axis_vertex_tready = 1;
  master_.present(top);
  device_.settle();
  master_.accept(top);
  device_.tick();
  REQUIRE_FALSE(device_.failed());
}

void DrivenDevice::wait(int clocks) {
  for (int i = 0; i < clocks; ++i) clock();
}

std::uint32_t DrivenDevice::access(bool write, std::uint32_t address, std::uint32_t value) {
  master_.start(write, address, value);
  for (int i = 0; i < kAnswerClocks && master_.busy(); ++i) clock();
  REQUIRE_FALSE(master_.busy());
  REQUIRE(master_.response() == 0);
  return master_.data();
}

std::uint32_t DrivenDevice::read(std::uint32_t address) { return access(false, address, 0); }
void DrivenDevice::write(std::uint32_t address, std::uint32_t value) {
  access(true, address, value);
}

void DrivenDevice::send_line(int width, bool start_of_frame) {
  Vtrihedron_top& top = device_.pins();
  for (int x = 0; x < width; ++x) {
    top.s_axis_tvalid = 1;
    top.s_axis_tuser = start_of_frame && x == 0;
    top.s_axis_tlast = x == width - 1;
    bool taken = false;
    for (int i = 0; i < kAcceptClocks && !taken; ++i) {
      device_.settle();
      taken = top.s_axis_tready & 1;
      clock();
    }
    REQUIRE(taken);
  }
  top.s_axis_tvalid = 0;
}

}  // namespace trihedron::driver

uint32_t trihedron_read(const struct trihedron_core*, uint32_t address) {
  return trihedron::driver::g_bus->read(address);
}

void trihedron_write(const struct trihedron_core*, uint32_t address, uint32_t value) {
  trihedron::driver::g_bus->write(address, value);
}
