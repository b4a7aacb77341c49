// SPDX-License-Identifier: Apache-2.0
#include "sim/register_checks.hpp"

#include <algorithm>
#include <string>

#include "golden/registers.hpp"
#include "sim/axi_lite_master.hpp"

namespace trihedron::sim {
namespace {

constexpr unsigned kAllBytes = AxiLiteMaster::kAllBytes;
constexpr std::uint32_t kMapEnd = 0x1000;
constexpr std::uint32_t kBlockWords = 16;  // of the global registers, gaps included
constexpr std::array<std::uint32_t, 4> kCounters = {registers::kFrames, registers::kVertices,
                                                    registers::kLost, registers::kErrors};

std::uint32_t of_view(std::uint32_t address, int view) {
  return address + registers::kViewStride * static_cast<std::uint32_t>(view);
}

/// Every register of the simulated build with its reset value; CYCLES has none.
std::vector<RegisterValue> reset_values() {
  std::vector<RegisterValue> values;
  for (const registers::Register& r : registers::kRegisters) {
    if (r.address == registers::kCycles) continue;
    const std::uint32_t limits = registers::kLimitsMaxWidth.put(kMaxWidthPx) |
                                 registers::kLimitsMaxHeight.put(kMaxHeightPx) |
                                 registers::kLimitsViews.put(kViews) |
                                 registers::kLimitsFractionBits.put(kGradientFractionBits);
    const std::uint32_t reset = r.address == registers::kLimits ? limits : r.reset;
    for (int view = 0; view < (r.per_view ? kViews : 1); ++view) {
      values.push_back({std::string(r.name) + " after reset", of_view(r.address, view), reset});
    }
  }
  return values;
}

bool has_register(std::uint32_t address) {
  return std::any_of(std::begin(registers::kRegisters), std::end(registers::kRegisters),
                     [address](const registers::Register& r) {
                       for (int view = 0; view < (r.per_view ? kViews : 1); ++view) {
                         if (of_view(r.address, view) == address) return true;
                       }
                       return false;
                     });
}

}  // namespace

void RegisterChecks::compare(const std::string& name, std::uint32_t expected, std::uint32_t got) {
  if (got == expected) {
    ++compared_;
    return;
  }
  if (mismatch_) return;
  mismatch_ = Mismatch{};
  mismatch_->stage = "register " + name;
  mismatch_->expected = std::to_string(expected);
  mismatch_->got = std::to_string(got);
}

void RegisterChecks::expect(const RegisterValue& expected) {
  compare(expected.name, expected.value, port_.read(expected.address));
}

void RegisterChecks::set(const RegisterValue& setting, bool by_bytes) {
  if (!by_bytes) {
    port_.write(setting.address, setting.value, kAllBytes);
  } else {
    std::array<unsigned, 4> lanes = {0, 1, 2, 3};
    for (unsigned left = 4; left > 1; --left) {
      std::swap(lanes[left - 1],
                lanes[static_cast<unsigned>(random_.between(0, static_cast<int>(left) - 1))]);
    }
    for (const unsigned lane : lanes) {
      const std::uint32_t mask = 0xffu << (8 * lane);
      const auto other = static_cast<std::uint32_t>(random_.next());
      port_.write(setting.address, (setting.value & mask) | (other & ~mask), 1u << lane);
    }
  }
  expect(setting);
}

void RegisterChecks::sweep_after_reset() {
  const std::vector<RegisterValue> values = reset_values();
  for (const RegisterValue& value : values) expect(value);
  for (const registers::Register& r : registers::kRegisters) {
    const std::uint32_t ones = ~(r.writable | r.sticky);
    for (int view = 0; view < (r.per_view ? kViews : 1); ++view) {
      // What can be written keeps its reset value, all other bits are attacked.
      port_.write(of_view(r.address, view), (r.reset & r.writable) | ones, kAllBytes);
    }
  }
  const auto attack = [this](std::uint32_t address) {
    if (has_register(address)) return;
    port_.write(address, static_cast<std::uint32_t>(random_.next()), kAllBytes);
    expect({"address " + std::to_string(address) + " without a register", address, 0});
  };
  // Every gap between registers, and some of the empty space beyond.
  for (std::uint32_t word = 0; word < kBlockWords; ++word)
    attack(registers::kGlobalBase + 4 * word);
  for (std::uint32_t at = registers::kViewBase; at < of_view(registers::kViewBase, kViews); at += 4)
    attack(at);
  for (int access = 0; access < 8; ++access)
    attack(static_cast<std::uint32_t>(random_.between(0, kMapEnd / 4 - 1)) * 4);
  for (const RegisterValue& value : values) expect(value);
  const std::uint32_t cycles = port_.read(registers::kCycles);
  compare("CYCLES, that it counts", 1, port_.read(registers::kCycles) > cycles);
}

void RegisterChecks::poll(int view) {
  const auto v = static_cast<std::size_t>(view);
  const std::uint32_t status = port_.read(of_view(registers::kStatus, view));
  if (status != 0) port_.write(of_view(registers::kStatus, view), status, kAllBytes);
  status_seen_[v] |= status;
  const auto which = static_cast<std::size_t>(random_.between(0, 3));
  const std::uint32_t count = port_.read(of_view(kCounters[which], view));
  compare("counter, that it does not run backwards", 1, count >= counters_seen_[v][which]);
  counters_seen_[v][which] = count;
}

void RegisterChecks::status(int view, const RegisterValue& expected, bool clear) {
  std::uint32_t left = port_.read(expected.address);
  compare(expected.name, expected.value, left | status_seen_[static_cast<std::size_t>(view)]);
  if (!clear) return;
  port_.write(expected.address, 0, kAllBytes);
  expect({expected.name + " after writing 0", expected.address, left});
  while (left != 0) {
    const std::uint32_t bit = left & (~left + 1);
    port_.write(expected.address, bit, bit < 0x100 ? 2 : 1);  // the lane of the bit left out
    expect({expected.name + " after a write to another byte", expected.address, left});
    port_.write(expected.address, bit, kAllBytes);
    left &= ~bit;
    expect({expected.name + " after clearing a bit", expected.address, left});
  }
}

}  // namespace trihedron::sim
