// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "sim/random.hpp"
#include "sim/registers.hpp"

namespace trihedron::sim {

/// Register accesses of a run and what they must read; counts what it compared and remembers the
/// first difference. Knows neither clocks nor SystemC.
class RegisterChecks {
 public:
  /// How accesses are made; both block until the access has ended.
  struct Port {
    std::function<std::uint32_t(std::uint32_t address)> read;
    std::function<void(std::uint32_t address, std::uint32_t data, unsigned strobe)> write;
  };

  RegisterChecks(Port port, std::uint64_t seed) : port_(std::move(port)), random_(seed) {}

  /// The register reads `expected`.
  void expect(const RegisterValue& expected);
  /// Writes and reads back; `by_bytes`: one byte lane at a time, in random order, other lanes of
  /// the data holding anything.
  void set(const RegisterValue& setting, bool by_bytes);
  /// Every register has its reset value, also after writes to all that cannot be written, and
  /// addresses without a register read 0.
  void sweep_after_reset();
  /// What a driver does while frames run: reads STATUS and a counter of `view`, writes back the
  /// STATUS bits that it saw. Counters never run backwards.
  void poll(int view);
  /// STATUS now holds what has happened and was not cleared by poll(): together, `expected`. Each
  /// of its bits then falls to a written 1, and to nothing else, if `clear`.
  void status(int view, const RegisterValue& expected, bool clear);

  std::uint64_t compared() const { return compared_; }
  const std::optional<Mismatch>& mismatch() const { return mismatch_; }

 private:
  void compare(const std::string& name, std::uint32_t expected, std::uint32_t got);

  Port port_;
  Random random_;
  std::array<std::uint32_t, kViews> status_seen_{};
  std::array<std::array<std::uint32_t, 4>, kViews> counters_seen_{};
  std::uint64_t compared_ = 0;
  std::optional<Mismatch> mismatch_;
};

}  // namespace trihedron::sim
