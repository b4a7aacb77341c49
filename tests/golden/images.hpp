// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden::test {

using Image = Plane<std::uint8_t>;

inline GradientImage gradient_of(const Image& image) {
  return gradient(image.samples.data(), image.width, image.height, image.width);
}

inline Image noise(int width, int height, unsigned seed) {
  Image image(width, height);
  std::mt19937 random(seed);
  for (auto& sample : image.samples) sample = static_cast<std::uint8_t>(random() & 255);
  return image;
}

/// Mirrored left to right.
template <typename T>
Plane<T> mirrored(const Plane<T>& in) {
  Plane<T> out(in.width, in.height);
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) out.at(x, y) = in.at(in.width - 1 - x, y);
  }
  return out;
}

/// Rows and columns exchanged.
template <typename T>
Plane<T> transposed(const Plane<T>& in) {
  Plane<T> out(in.height, in.width);
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) out.at(y, x) = in.at(x, y);
  }
  return out;
}

}  // namespace trihedron::golden::test
