// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace trihedron::render {

/// Mixes a 64-bit state into 64 well spread bits (the SplitMix64 finalizer).
inline std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// A stream of random numbers that is the same on every machine: the standard library leaves the
/// algorithms of its distributions open. The stream is a function of (seed, stream) alone, so one
/// per pixel or per scene gives results that do not depend on the order of work.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mix(seed) ^ mix(~stream)) {}

  std::uint64_t bits() { return mix(state_++); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In 0 .. n - 1, n > 0.
  int below(int n) { return static_cast<int>(uniform() * n); }
  /// Normal with mean 0 and standard deviation 1 (Box and Muller).
  double normal() {
    const double u = 1.0 - uniform();
    constexpr double kTwoPi = 6.283185307179586;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(kTwoPi * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace trihedron::render
