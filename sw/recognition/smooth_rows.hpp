// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

/// One row of a view's gradient, smoothed with the 3x3 binomial [1 2 1] (x) [1 2 1] / 16, in
/// stream units.
struct SmoothRow {
  std::vector<float> gx, gy, magnitude;
};

/// Rows of one view smoothed along themselves, the last three that were asked for: rows that follow
/// each other share two of them.
class RowSums {
 public:
  using Slopes =
      std::vector<std::int16_t>;  ///< gx and gy in turn, so that sums take both at a time

  /// Of the pixels 1 to width - 2 of row y, times 4; the row is at least 3 pixels wide.
  const Slopes& of(const ViewFeatures& features, int y);

 private:
  std::array<Slopes, 3> sums_;
  std::array<int, 3> row_{-1, -1, -1};
};

/// Computes row y of `features`; the image's outermost pixels are 0 (border rule). `sums` belongs
/// to the view; the row's memory is reused.
void smooth_row(const ViewFeatures& features, int y, RowSums& sums, SmoothRow& row);

/// The smoothed rows around a middle one that moves down the image: seven rows stay in the
/// processor's cache, an image's worth would be written to memory and read back.
class SmoothRows {
 public:
  static constexpr int kReach = 3;  ///< rows on either side of the middle one

  explicit SmoothRows(const ViewFeatures& features) : features_(features) {}

  int width() const { return features_.width; }
  int height() const { return features_.height; }
  /// Makes y the middle row; the calls go down the image from its top.
  void move_to(int y);
  /// A row of the image within kReach of the middle one.
  const SmoothRow& row(int y) const {
    return *around_[static_cast<std::size_t>(y - middle_ + kReach)];
  }

 private:
  const ViewFeatures& features_;
  RowSums sums_;
  std::array<SmoothRow, 2 * kReach + 1> rows_;
  std::array<const SmoothRow*, 2 * kReach + 1> around_{};  // from middle_ - kReach on
  int middle_ = 0;
  int next_ = 0;  // first row not computed yet
};

}  // namespace trihedron
