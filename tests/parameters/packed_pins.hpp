// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <cstddef>
#include <cstdint>

namespace trihedron::parameters {

// Ports of `Views` fields side by side: Verilator makes them integers up to 64 bits and arrays of
// 32-bit words above.

template <typename Pin>
std::uint64_t field(const Pin& pin, int lsb, int bits) {
  const std::uint64_t mask = bits == 64 ? ~0ull : (1ull << bits) - 1;
  return static_cast<std::uint64_t>(pin) >> lsb & mask;
}

template <std::size_t Words>
std::uint64_t field(const VlWide<Words>& pin, int lsb, int bits) {
  std::uint64_t out = 0;
  for (int i = 0; i < bits; ++i)
    out |= static_cast<std::uint64_t>(pin[(lsb + i) / 32] >> (lsb + i) % 32 & 1) << i;
  return out;
}

template <typename Pin>
void set_field(Pin& pin, int lsb, int bits, std::uint64_t value) {
  const std::uint64_t mask = ((1ull << bits) - 1) << lsb;
  pin = static_cast<Pin>((static_cast<std::uint64_t>(pin) & ~mask) | (value << lsb & mask));
}

template <std::size_t Words>
void set_field(VlWide<Words>& pin, int lsb, int bits, std::uint64_t value) {
  for (int i = 0; i < bits; ++i) {
    const std::uint32_t bit = 1u << (lsb + i) % 32;
    if (value >> i & 1)
      pin[(lsb + i) / 32] |= bit;
    else
      pin[(lsb + i) / 32] &= ~bit;
  }
}

}  // namespace trihedron::parameters
