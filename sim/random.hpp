// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// SplitMix64 (Steele, Lea, Flood 2014): 64 random bits a call, equal on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Uniform in [low, high].
  int between(int low, int high) {
    const std::uint64_t span = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(((next() >> 32) * span) >> 32);
  }

  bool chance(double probability) {
    return static_cast<double>(next() >> 11) * 0x1p-53 < probability;
  }

 private:
  std::uint64_t state_;
};

/// Says clock by clock whether a stream stalls.
class Stall {
 public:
  Stall(const StallProfile& profile, std::uint64_t seed)
      : random_(seed),
        threshold_(static_cast<std::uint64_t>(profile.probability * 0x1p32)),
        longest_(profile.longest) {}

  bool at_this_clock() {
    if (left_ > 0) {
      --left_;
      return true;
    }
    if (threshold_ == 0 || (random_.next() >> 32) >= threshold_) return false;
    left_ = random_.between(0, longest_ - 1);
    return true;
  }

 private:
  Random random_;
  std::uint64_t threshold_;
  int longest_;
  int left_ = 0;
};

}  // namespace trihedron::sim
