// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace trihedron {

/// An edge that would leave a point in space in some direction: what the views say about it,
/// whatever its length. Worked out once for all models that have an edge there.
class Spoke {
 public:
  /// Log likelihood ratio "the edge is there and `length_mm` long" against segments by chance.
  float evidence(float length_mm) const {
    if (sums_.empty()) return 0;
    const auto last = static_cast<float>(sums_.size() - 1);
    return sums_[static_cast<std::size_t>(std::min(length_mm * steps_per_mm_, last))];
  }

 private:
  friend class Evidence;

  float steps_per_mm_ = 0;
  std::vector<float> sums_;  ///< evidence of the samples up to a length, in steps
};

}  // namespace trihedron
