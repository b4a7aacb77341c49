// SPDX-License-Identifier: Apache-2.0
#include "recognition/spread_map.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// Contours within this of a predicted line are its own, px.
constexpr double kOwnPx = 2.5;
/// A point counts as found within about 2 px on either side of a contour.
constexpr double kBandPx = 4;
/// No chance is smaller than this: specks of noise are everywhere.
constexpr double kLeastChance = 0.02;

bool is_explained(const ContourField::Pixel& pixel, const std::vector<VisibleEdge>& lines) {
  const Eigen::Vector2d x(pixel.x, pixel.y);
  for (const VisibleEdge& line : lines) {
    if (std::abs(line.normal.dot(x - line.x0)) > kOwnPx) continue;
    const double along = (line.x1 - line.x0).dot(x - line.x0) / std::max(line.length_px, 1e-9);
    if (along < -kOwnPx || along > line.length_px + kOwnPx) continue;
    const int turn = std::abs(ContourField::bin_of(line.normal.x(), line.normal.y()) - pixel.bin);
    if (turn <= 1 || turn == ContourField::kBins - 1) return true;
  }
  return false;
}

/// ORs each cell's byte into its eight neighbours.
void spread(int columns, int rows, std::vector<std::uint8_t>& cells) {
  const std::vector<std::uint8_t> own = cells;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * columns + x; };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if (!own[at(x, y)]) continue;
      for (int j = std::max(0, y - 1); j <= std::min(rows - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(columns - 1, x + 1); ++i) {
          cells[at(i, j)] |= own[at(x, y)];
        }
      }
    }
  }
}

}  // namespace

SpreadMap spread_map(const ContourField& field, const std::vector<VisibleEdge>& explained) {
  constexpr int kBins = ContourField::kBins;
  SpreadMap out;
  out.columns = (field.width() + SpreadMap::kCellPx - 1) / SpreadMap::kCellPx;
  out.rows = (field.height() + SpreadMap::kCellPx - 1) / SpreadMap::kCellPx;
  const auto count = static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows);
  out.cells.assign(count, 0);
  double pixels[kBins] = {};
  for (const ContourField::Pixel& pixel : field.pixels()) {
    if (is_explained(pixel, explained)) continue;
    ++pixels[pixel.bin];
    out.cells[static_cast<std::size_t>(pixel.y / SpreadMap::kCellPx) * out.columns +
              pixel.x / SpreadMap::kCellPx] |= static_cast<std::uint8_t>(1U << pixel.bin);
  }
  spread(out.columns, out.rows, out.cells);
  double occupied = 0;
  for (std::uint8_t mask : out.cells) {
    if (!mask) continue;
    ++occupied;
    for (int bin = 0; bin < kBins; ++bin) out.density[bin] += (mask >> bin) & 1;
  }
  const double area = std::max(1.0, occupied * SpreadMap::kCellPx * SpreadMap::kCellPx);
  for (int bin = 0; bin < kBins; ++bin) {
    out.density[bin] /= static_cast<double>(std::max<std::size_t>(1, count));
    const double three =
        pixels[bin] + pixels[(bin + 1) % kBins] + pixels[(bin + kBins - 1) % kBins];
    out.found[bin] = std::clamp(kBandPx * three / area, kLeastChance, 0.9);
  }
  return out;
}

}  // namespace trihedron
