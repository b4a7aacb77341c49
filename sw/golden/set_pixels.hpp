// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>

namespace trihedron::golden {

/// Calls visit(x) for every x in begin .. end - 1 with row[x] != 0, in order. Eight zeros cost one
/// comparison: contours leave most of an image empty.
template <typename Visit>
void for_each_set(const std::uint8_t* row, int begin, int end, Visit visit) {
  constexpr int kWordPx = sizeof(std::uint64_t);
  int x = begin;
  for (; x + kWordPx <= end; x += kWordPx) {
    std::uint64_t word;
    std::memcpy(&word, row + x, sizeof word);
    if (word == 0) continue;
    for (int i = x; i < x + kWordPx; ++i) {
      if (row[i] != 0) visit(i);
    }
  }
  for (; x < end; ++x) {
    if (row[x] != 0) visit(x);
  }
}

}  // namespace trihedron::golden
