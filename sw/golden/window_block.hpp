// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "golden/plane.hpp"

namespace trihedron::golden {

/// Pixels that a stage computes side by side: long enough for vector registers of any width.
constexpr int kBlockPx = 32;

/// The 5x5 windows of kBlockPx centres in a row, as 16-bit values of their own: fixed trip counts
/// and no aliasing let the compiler vectorise what is written per pixel. Centre i is column
/// i + kWindowRadius; centres beyond the row's end have zeros.
struct WindowBlock {
  std::int16_t rows[kMinFrameSide][kBlockPx + 2 * kWindowRadius];

  /// From the rows y - 2 .. y + 2 of a frame, starting at the centre in column x.
  template <typename T>
  void load(const std::array<const T*, kMinFrameSide>& source, int x, int width) {
    constexpr int kColumns = kBlockPx + 2 * kWindowRadius;
    const int left = x - kWindowRadius;
    const int columns = width - left < kColumns ? width - left : kColumns;
    for (int j = 0; j < kMinFrameSide; ++j) {
      const T* in = source[static_cast<std::size_t>(j)] + left;
      if (columns == kColumns) {
        for (int i = 0; i < kColumns; ++i) rows[j][i] = static_cast<std::int16_t>(in[i]);
      } else {
        for (int i = 0; i < columns; ++i) rows[j][i] = static_cast<std::int16_t>(in[i]);
        for (int i = columns; i < kColumns; ++i) rows[j][i] = 0;
      }
    }
  }
};

/// Copies the first n values of a block; a whole block has a fixed size, hence no loop.
template <typename T>
void store_block(const T* block, int n, T* out) {
  if (n == kBlockPx) {
    std::memcpy(static_cast<void*>(out), block, kBlockPx * sizeof(T));
  } else {
    std::copy_n(block, n, out);
  }
}

/// The five rows around row y.
template <typename T>
std::array<const T*, kMinFrameSide> window_rows(const Plane<T>& plane, int y) {
  std::array<const T*, kMinFrameSide> rows{};
  for (int j = 0; j < kMinFrameSide; ++j) {
    rows[static_cast<std::size_t>(j)] = plane.row(y - kWindowRadius + j);
  }
  return rows;
}

}  // namespace trihedron::golden
