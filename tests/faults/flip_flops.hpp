// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"

#include <verilated_syms.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "golden/registers.hpp"

namespace trihedron::faults {

/// The flip-flops of a device, bit by bit: the variables that flip_flops.py made writable.
class FlipFlops {
 public:
  explicit FlipFlops(sim::Device& device) {
    for (const auto& [scope, content] : *device.context().scopeNameMap()) {
      if (content->varsp() == nullptr) continue;
      for (const auto& [name, variable] : *content->varsp()) {
        if (!variable.isPublicRW()) continue;
        const auto bits = static_cast<std::size_t>(variable.packed().elements());
        const std::size_t words = variable.udims() > 0 ? variable.unpacked().elements() : 1;
        variables_.push_back({short_name(scope) + "." + name,
                              static_cast<unsigned char*>(variable.datap()), bits,
                              variable.entSize()});
        bits_ += bits * words;
        ends_.push_back(bits_);
      }
    }
  }

  std::size_t count() const { return bits_; }

  /// The variable and bit of flip-flop `index`, with its instance path below the top.
  std::string name(std::size_t index) const {
    const std::size_t v = which(index);
    return variables_[v].name + "[" + std::to_string(index - first(v)) + "]";
  }

  /// The index of the one that name() calls `wanted`; count() when there is none.
  std::size_t find(const std::string& wanted) const {
    std::size_t index = 0;
    while (index < bits_ && name(index) != wanted) ++index;
    return index;
  }

  /// Bits of a register bank that nobody can write stay 0 and vanish in synthesis.
  bool exists(std::size_t index) const {
    const std::size_t v = which(index);
    const bool global = variables_[v].name == "i_global.value_o";
    if (!global && variables_[v].name.find("i_bank.value_o") == std::string::npos) return true;
    const std::size_t bit = index - first(v);
    const auto address = static_cast<std::uint32_t>(bit / 32 * 4) +
                         (global ? registers::kGlobalBase : registers::kViewBase);
    for (const registers::Register& r : registers::kRegisters) {
      if (r.address == address) return ((r.writable | r.sticky) >> (bit % 32)) & 1;
    }
    return false;
  }

  void flip(std::size_t index) {
    const std::size_t v = which(index);
    const Variable& variable = variables_[v];
    const std::size_t bit = index - first(v);
    // Bits of one word lie together; words of an unpacked array follow each other.
    const std::size_t byte = bit / variable.bits * variable.word_bytes + bit % variable.bits / 8;
    variable.data[byte] =
        static_cast<unsigned char>(variable.data[byte] ^ (1u << (bit % variable.bits % 8)));
  }

 private:
  struct Variable {
    std::string name;
    unsigned char* data;  // little endian, as Verilator stores every width
    std::size_t bits, word_bytes;
  };

  // Verilator repeats the top's name in front.
  static std::string short_name(const std::string& scope) {
    const std::size_t second = scope.find('.', scope.find('.') + 1);
    return second == std::string::npos ? "top" : scope.substr(second + 1);
  }
  std::size_t first(std::size_t v) const { return v == 0 ? 0 : ends_[v - 1]; }
  std::size_t which(std::size_t index) const {
    return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), index) -
                                    ends_.begin());
  }

  std::vector<Variable> variables_;
  std::vector<std::size_t> ends_;
  std::size_t bits_ = 0;
};

}  // namespace trihedron::faults
