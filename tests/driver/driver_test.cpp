// SPDX-License-Identifier: Apache-2.0
// The C driver and its generated header against the register file of the simulated top, through
// AXI4-Lite.
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "driver/driven_device.hpp"

extern "C" {
#include "trihedron.h"
}

using trihedron::driver::DrivenDevice;

namespace {

constexpr std::uint32_t kAllBits = 0xffffffffu;

/// One register as the C header describes it.
struct HeaderRegister {
  std::uint32_t address = 0;
  std::uint32_t bits = 0;  ///< of all its fields
};

/// The header's registers by name, and its fields' masks and lowest bits checked against each
/// other.
std::map<std::string, HeaderRegister> read_header() {
  std::ifstream file(TRIHEDRON_REGISTERS_HEADER);
  std::map<std::string, HeaderRegister> registers;
  std::string line, current;
  std::uint32_t mask = 0;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string define, name, value;
    words >> define >> name >> value;
    if (define != "#define" || value.empty() || name.find('(') != std::string::npos) continue;
    const auto number = static_cast<std::uint32_t>(std::stoul(value, nullptr, 0));
    const auto ends_with = [&](const std::string& end) {
      return name.size() > end.size() && name.substr(name.size() - end.size()) == end;
    };
    if (ends_with("_MASK")) {
      mask = number;
      REQUIRE((registers[current].bits & mask) == 0);  // fields do not overlap
      registers[current].bits |= mask;
    } else if (ends_with("_LSB")) {
      REQUIRE((mask >> number & 1) == 1);
      REQUIRE((mask & ((1u << number) - 1)) == 0);
    } else {
      current = name;
      registers[current].address = number;
    }
  }
  return registers;
}

/// Which of a register's bits hold what is written.
std::uint32_t writable(DrivenDevice& device, std::uint32_t address) {
  const std::uint32_t before = device.read(address);
  device.write(address, kAllBits);
  const std::uint32_t ones = device.read(address);
  device.write(address, 0);
  const std::uint32_t zeros = device.read(address);
  device.write(address, before);
  return ones & ~zeros;
}

bool is_per_view(std::uint32_t address) { return address >= TRIHEDRON_STATUS; }

struct Opened {
  DrivenDevice device;
  trihedron_core core{};
  Opened() {
    trihedron::driver::g_bus = &device;
    REQUIRE(trihedron_open(&core, nullptr) == 0);
  }
};

void send_frame(DrivenDevice& device, int width, int lines) {
  for (int y = 0; y < lines; ++y) device.send_line(width, y == 0);
}

/// More than a frame of 8 px needs to leave.
constexpr int kDrainClocks = 1000;

}  // namespace

TEST_CASE(
    "every bit that the C header names is where the RTL has it, and no other can be written") {
  DrivenDevice device;
  const std::set<std::string> writable_registers{
      "TRIHEDRON_CONTROL",      "TRIHEDRON_FRAME_HEIGHT", "TRIHEDRON_FLUSH_TIMEOUT",
      "TRIHEDRON_VERTEX_LIMIT", "TRIHEDRON_NOISE_FLOOR",  "TRIHEDRON_MEAN_LIMIT",
      "TRIHEDRON_SUPPORT",      "TRIHEDRON_BRANCH_FLOOR", "TRIHEDRON_MIN_TURN"};
  std::set<std::uint32_t> addresses;
  for (const auto& [name, one] : read_header()) {
    INFO(name);
    for (std::uint32_t view = 0; view < (is_per_view(one.address) ? 3u : 1u); ++view) {
      const std::uint32_t address = TRIHEDRON_VIEW(one.address, view);
      CHECK(addresses.insert(address).second);
      CHECK((device.read(address) & ~one.bits) == 0);
      if (name == "TRIHEDRON_CYCLES") continue;  // counts while it is read
      CHECK(writable(device, address) == (writable_registers.count(name) ? one.bits : 0));
    }
  }
  CHECK(addresses.size() == 13 + 3 * 6);
  // Nothing else is there.
  for (std::uint32_t address = 0; address < 0x1000; address += 4) {
    if (addresses.count(address)) continue;
    INFO("address " << address);
    CHECK(device.read(address) == 0);
    if (address % 0x40 == 0x3c) CHECK(writable(device, address) == 0);
  }
}

TEST_CASE("CYCLES counts and cannot be written") {
  DrivenDevice device;
  const std::uint32_t before = device.read(TRIHEDRON_CYCLES);
  device.write(TRIHEDRON_CYCLES, 0);
  const std::uint32_t after = device.read(TRIHEDRON_CYCLES);
  CHECK(after > before);
  CHECK(after < before + 100);
}

TEST_CASE("the driver opens the core and reads its limits") {
  Opened opened;
  CHECK(opened.core.views == 3);
  CHECK(opened.core.max_width == 1920);
  CHECK(opened.core.max_height == 1200);
}

TEST_CASE("the driver's thresholds reach their registers and end without hold") {
  Opened opened;
  const trihedron_thresholds to{0x155, 0x0a, 0x2aaa, 0x0aa, 0x15};
  trihedron_set_thresholds(&opened.core, &to);
  CHECK(opened.device.read(TRIHEDRON_NOISE_FLOOR) == to.noise_floor);
  CHECK(opened.device.read(TRIHEDRON_MEAN_LIMIT) == to.mean_limit);
  CHECK(opened.device.read(TRIHEDRON_SUPPORT) == to.support);
  CHECK(opened.device.read(TRIHEDRON_BRANCH_FLOOR) == to.branch_floor);
  CHECK(opened.device.read(TRIHEDRON_MIN_TURN) == to.min_turn);
  CHECK(opened.device.read(TRIHEDRON_CONTROL) == TRIHEDRON_CONTROL_ENABLE_MASK);
}

TEST_CASE("a started core counts a frame that the driver then sees") {
  Opened opened;
  trihedron_start(&opened.core, 6, 100);
  CHECK(opened.device.read(TRIHEDRON_FRAME_HEIGHT) == 6);
  CHECK(opened.device.read(TRIHEDRON_VERTEX_LIMIT) == 100);
  CHECK(trihedron_counts(&opened.core, 0).frames == 0);
  send_frame(opened.device, 8, 6);
  opened.device.wait(kDrainClocks);
  CHECK(trihedron_counts(&opened.core, 0).frames == 1);
  CHECK(trihedron_counts(&opened.core, 0).last_frame == 0);  // flat: no vertices
  CHECK(trihedron_counts(&opened.core, 1).frames == 0);
  CHECK(trihedron_take_status(&opened.core, 0) == 0);
}

TEST_CASE("each bad stream sets the status bit of its name, which the driver takes once") {
  Opened opened;
  trihedron_start(&opened.core, 0, 100);
  DrivenDevice& device = opened.device;
  const auto taken = [&] {
    device.wait(10);
    CHECK(trihedron_take_status(&opened.core, 1) == 0);
    const std::uint32_t status = trihedron_take_status(&opened.core, 0);
    CHECK(trihedron_take_status(&opened.core, 0) == 0);
    return status;
  };
  device.send_line(8, false);
  CHECK(taken() == TRIHEDRON_STATUS_NO_START_MASK);
  device.send_line(4, true);
  CHECK(taken() == TRIHEDRON_STATUS_TOO_NARROW_MASK);
  send_frame(device, 8, 5);
  device.send_line(7, false);
  CHECK(taken() == TRIHEDRON_STATUS_SHORT_LINE_MASK);
  send_frame(device, 8, 5);
  device.send_line(9, false);
  CHECK(taken() == TRIHEDRON_STATUS_LONG_LINE_MASK);
  send_frame(device, 8, 3);
  device.send_line(8, true);
  CHECK(taken() == TRIHEDRON_STATUS_TOO_FEW_ROWS_MASK);
}
