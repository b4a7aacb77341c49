// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recognition/contour_field.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

/// Where contours of which direction are, coarsely: one byte of direction bins per cell, spread
/// to the cells around it. Answers "is there such a contour within 4 to 8 px" in a few
/// nanoseconds, and how likely that is by chance.
struct SpreadMap {
  static constexpr int kCellPx = 4;

  int columns = 0, rows = 0;
  std::vector<std::uint8_t> cells;
  double density[ContourField::kBins] = {};  ///< share of cells that hold the bin
  /// Probability that a random point within some 6 px of a contour lies on a contour (within
  /// 2 px) of about the bin's direction.
  double found[ContourField::kBins] = {};

  /// Whether a contour of the bin's direction is near pixel (x, y), which lies in the image.
  bool near(int x, int y, int bin) const {
    return (cells[static_cast<std::size_t>(y / kCellPx) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(x / kCellPx)] >>
            bin) &
           1;
  }
};

/// The map of all contours but those that `explained` lines predict.
SpreadMap spread_map(const ContourField& field, const std::vector<VisibleEdge>& explained = {});

}  // namespace trihedron
