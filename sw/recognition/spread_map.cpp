// SPDX-License-Identifier: Apache-2.0
#include "recognition/spread_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trihedron {
namespace {

/// Contours within this of a predicted line are its own, px.
constexpr double kOwnPx = 2.5;
/// A point counts as found within about 2 px on either side of a contour.
constexpr double kBandPx = 4;
/// No chance is smaller than this: specks of noise are everywhere.
constexpr double kLeastChance = 0.02;

/// Marks the contour pixels along a predicted line that run in its direction, row by row.
void mark_own(const ContourField& field, const VisibleEdge& line, std::vector<char>& own) {
  const double length = std::max(line.length_px, 1e-9);
  const Eigen::Vector2d along = (line.x1 - line.x0) / length;
  const double offset = line.normal.dot(line.x0), start = along.dot(line.x0);
  const int bin = ContourField::bin_of(line.normal.x(), line.normal.y());
  // Where a row crosses the strip low <= n . x <= high.
  const auto clip = [](double n_x, double rest, double low, double high, double& from, double& to) {
    if (std::abs(n_x) < 1e-9) return;
    const double a = (low - rest) / n_x, b = (high - rest) / n_x;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  const double low_y = std::min(line.x0.y(), line.x1.y()),
               high_y = std::max(line.x0.y(), line.x1.y());
  const int first = static_cast<int>(std::clamp(low_y - 2 * kOwnPx, 0.0, field.height() - 1.0));
  const int last = static_cast<int>(std::clamp(high_y + 2 * kOwnPx, 0.0, field.height() - 1.0));
  const auto& pixels = field.pixels();
  for (int y = first; y <= last; ++y) {
    double from = 0, to = field.width();
    clip(line.normal.x(), line.normal.y() * y, offset - kOwnPx, offset + kOwnPx, from, to);
    clip(along.x(), along.y() * y, start - kOwnPx, start + length + kOwnPx, from, to);
    const auto [begin, end] = field.row(y);
    const auto left_of = [](const ContourField::Pixel& p, double x) { return p.x < x; };
    auto i = static_cast<std::size_t>(
        std::lower_bound(pixels.begin() + begin, pixels.begin() + end, from - 1, left_of) -
        pixels.begin());
    for (; i < static_cast<std::size_t>(end) && pixels[i].x <= to + 1; ++i) {
      const Eigen::Vector2d x(pixels[i].x, y);
      const double t = along.dot(x) - start;
      const int turn = std::abs(bin - pixels[i].bin);
      if (std::abs(line.normal.dot(x) - offset) <= kOwnPx && t >= -kOwnPx && t <= length + kOwnPx &&
          (turn <= 1 || turn == ContourField::kBins - 1)) {
        own[i] = 1;
      }
    }
  }
}

/// ORs each cell's byte into its eight neighbours.
void spread(int columns, int rows, std::vector<std::uint8_t>& cells) {
  const auto width = static_cast<std::size_t>(columns);
  const auto mix = [](const std::uint8_t* a, const std::uint8_t* b, std::size_t n,
                      std::uint8_t* out) {
    for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<std::uint8_t>(a[i] | b[i]);
  };
  // Along the rows, with a row of nothing above and below, ...
  std::vector<std::uint8_t> along(cells.size() + 2 * width, 0);
  for (int y = 0; y < rows; ++y) {
    const std::uint8_t* from = &cells[static_cast<std::size_t>(y) * width];
    std::uint8_t* to = &along[static_cast<std::size_t>(y + 1) * width];
    std::copy(from, from + width, to);
    mix(to + 1, from, width - 1, to + 1);
    mix(to, from + 1, width - 1, to);
  }
  // ... and across them.
  mix(&along[0], &along[width], cells.size(), cells.data());
  mix(cells.data(), &along[2 * width], cells.size(), cells.data());
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
  std::vector<char> own(field.pixels().size(), 0);
  for (const VisibleEdge& line : explained) mark_own(field, line, own);
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]) continue;
    const ContourField::Pixel& pixel = field.pixels()[i];
    ++pixels[pixel.bin];
    out.cells[static_cast<std::size_t>(pixel.y / SpreadMap::kCellPx) * out.columns +
              pixel.x / SpreadMap::kCellPx] |= static_cast<std::uint8_t>(1U << pixel.bin);
  }
  spread(out.columns, out.rows, out.cells);
  std::array<int, 1U << kBins> with_mask{};
  for (std::uint8_t mask : out.cells) ++with_mask[mask];
  double occupied = 0;
  for (std::size_t mask = 1; mask < with_mask.size(); ++mask) {
    occupied += with_mask[mask];
    for (int bin = 0; bin < kBins; ++bin) {
      if ((mask >> bin) & 1) out.density[bin] += with_mask[mask];
    }
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
