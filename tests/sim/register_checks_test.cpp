// SPDX-License-Identifier: Apache-2.0
// The register checks on trial: a register file in software, faultless and with one fault at a
// time.
#include "sim/register_checks.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "golden/registers.hpp"

using namespace trihedron;
using namespace trihedron::sim;
using Catch::Matchers::Contains;

namespace {

/// What can be wrong with a register file.
enum class Defect {
  kNone,
  kReset,       ///< MIN_TURN has another reset value
  kReadOnly,    ///< ID can be written
  kStrobe,      ///< strobes are ignored
  kStray,       ///< an address without a register reads something
  kStickyZero,  ///< writing 0 clears STATUS
  kCounter,     ///< counters run backwards
};

class RegisterFile {
 public:
  explicit RegisterFile(Defect fault) : fault_(fault) {
    for (const registers::Register& r : registers::kRegisters) {
      for (int view = 0; view < (r.per_view ? kViews : 1); ++view) {
        const auto address = r.address + static_cast<std::uint32_t>(view) * registers::kViewStride;
        values_[address] = r.reset;
        map_[address] = &r;
      }
    }
    values_[registers::kLimits] = kMaxWidthPx | kMaxHeightPx << 12 | kViews << 24 | 3u << 28;
    if (fault_ == Defect::kReset) values_[registers::kMinTurn] ^= 1;
  }

  std::uint32_t read(std::uint32_t address) {
    if (map_.count(address) == 0) return fault_ == Defect::kStray ? 1 : 0;
    if (address == registers::kCycles) return ++cycles_;
    std::uint32_t& value = values_[address];
    if (fault_ == Defect::kCounter && address == registers::kFrames && value > 0) --value;
    return value;
  }
  void write(std::uint32_t address, std::uint32_t data, unsigned strobe) {
    if (map_.count(address) == 0) return;
    const registers::Register& r = *map_[address];
    std::uint32_t lanes = 0;
    for (unsigned lane = 0; lane < 4; ++lane) {
      if ((strobe >> lane & 1) || fault_ == Defect::kStrobe) lanes |= 0xffu << (8 * lane);
    }
    const bool id = fault_ == Defect::kReadOnly && address == registers::kId;
    const std::uint32_t writable = id ? ~0u : r.writable & lanes;
    values_[address] = (values_[address] & ~writable) | (data & writable);
    values_[address] &= ~(data & r.sticky & lanes);
    if (fault_ == Defect::kStickyZero && r.sticky != 0 && data == 0) values_[address] = 0;
  }
  std::uint32_t& value(std::uint32_t address) { return values_[address]; }

 private:
  Defect fault_;
  std::map<std::uint32_t, std::uint32_t> values_;
  std::map<std::uint32_t, const registers::Register*> map_;
  std::uint32_t cycles_ = 0;
};

std::string first_difference(Defect fault) {
  RegisterFile file(fault);
  RegisterChecks checks({[&](std::uint32_t address) { return file.read(address); },
                         [&](std::uint32_t address, std::uint32_t data, unsigned strobe) {
                           file.write(address, data, strobe);
                         }},
                        1);
  checks.sweep_after_reset();
  checks.set({"NOISE_FLOOR", registers::kNoiseFloor, 0x155}, true);
  file.value(registers::kFrames) = 9;
  for (int poll = 0; poll < 20; ++poll) checks.poll(0);
  file.value(registers::kStatus) = 0x105;
  checks.status(0, {"STATUS", registers::kStatus, 0x105}, true);
  CHECK(checks.compared() > 50);
  return checks.mismatch() ? checks.mismatch()->stage : "";
}

}  // namespace

TEST_CASE("a faultless register file passes every check") {
  CHECK(first_difference(Defect::kNone).empty());
}

TEST_CASE("each fault of a register file is noticed and named") {
  CHECK_THAT(first_difference(Defect::kReset), Contains("MIN_TURN after reset"));
  CHECK_THAT(first_difference(Defect::kReadOnly), Contains("ID after reset"));
  CHECK_THAT(first_difference(Defect::kStrobe), Contains("NOISE_FLOOR"));
  CHECK_THAT(first_difference(Defect::kStray), Contains("without a register"));
  CHECK_THAT(first_difference(Defect::kStickyZero), Contains("STATUS after writing 0"));
  CHECK_THAT(first_difference(Defect::kCounter), Contains("backwards"));
}

TEST_CASE("events that polling has cleared still count") {
  RegisterFile file(Defect::kNone);
  RegisterChecks checks({[&](std::uint32_t address) { return file.read(address); },
                         [&](std::uint32_t address, std::uint32_t data, unsigned strobe) {
                           file.write(address, data, strobe);
                         }},
                        1);
  file.value(registers::kStatus) = 0x81;
  checks.poll(0);
  CHECK(file.value(registers::kStatus) == 0);
  file.value(registers::kStatus) = 0x02;
  checks.status(0, {"STATUS", registers::kStatus, 0x83}, false);
  CHECK_FALSE(checks.mismatch());
  checks.status(0, {"STATUS", registers::kStatus, 0xc3}, false);
  CHECK(checks.mismatch());
}
