// SPDX-License-Identifier: Apache-2.0
#include "recognition/edgels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "recognition/smooth_rows.hpp"

namespace trihedron {
namespace {

/// Sigma of one gradient component from the median of a Rayleigh distributed magnitude.
float estimate_noise(const ViewFeatures& f, float floor) {
  // Smoothing correlates neighbours: a pixel in sixteen says as much as all of them.
  constexpr int kRowStep = 8;
  constexpr std::size_t kColumnStep = 2;
  std::vector<float> sample;
  RowSums sums;
  SmoothRow row;
  for (int y = kRowStep / 2; y < f.height; y += kRowStep) {
    smooth_row(f, y, sums, row);
    for (std::size_t x = 0; x < row.magnitude.size(); x += kColumnStep) {
      sample.push_back(row.magnitude[x]);
    }
  }
  if (sample.empty()) return floor;
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  constexpr float kMedianOfRayleigh = 1.17741F;
  return std::max(floor, *middle / kMedianOfRayleigh);
}

/// Magnitudes one step along +gradient and -gradient, interpolated between the two pixels that
/// the gradient's line passes; the step is `length` px long.
struct Across {
  float ahead, behind, length;
};

Across sample_across(const SmoothRows& rows, std::size_t x, int y, float gx, float gy) {
  const float* up = rows.row(y - 1).magnitude.data() + x;
  const float* mid = rows.row(y).magnitude.data() + x;
  const float* down = rows.row(y + 1).magnitude.data() + x;
  const float* ahead = gy > 0 ? down : up;  // the row that the gradient points to
  const float* behind = gy > 0 ? up : down;
  const std::ptrdiff_t right = gx > 0 ? 1 : -1;
  if (std::abs(gx) >= std::abs(gy)) {
    const float slope = std::abs(gy / gx);
    return {mid[right] * (1 - slope) + ahead[right] * slope,
            mid[-right] * (1 - slope) + behind[-right] * slope, std::sqrt(1 + slope * slope)};
  }
  const float slope = std::abs(gx / gy);
  return {ahead[0] * (1 - slope) + ahead[right] * slope,
          behind[0] * (1 - slope) + behind[-right] * slope, std::sqrt(1 + slope * slope)};
}

/// Smoothed gradient along (nx, ny) at the pixel nearest to (x, y) + step * (nx, ny).
float beside(const SmoothRows& rows, int x, int y, float nx, float ny, float step) {
  // Within kReach of a pixel of the image: with that added, cutting the fraction off rounds.
  constexpr int kShift = SmoothRows::kReach;
  const int px = static_cast<int>(static_cast<float>(x + kShift) + step * nx + 0.5F) - kShift;
  const int py = static_cast<int>(static_cast<float>(y + kShift) + step * ny + 0.5F) - kShift;
  if (px < 0 || py < 0 || px >= rows.width() || py >= rows.height()) return 0;
  const SmoothRow& row = rows.row(py);
  const auto i = static_cast<std::size_t>(px);
  return row.gx[i] * nx + row.gy[i] * ny;
}

/// Ridges that are no edges of objects. Two to three pixels beside an edge, the derivative's masks
/// overshoot: their response has the opposite sign and up to 1/5 of the edge's. On a ramp wider
/// than the optics' blur, the border of a soft shadow, both sides are nearly as steep.
bool is_spurious(const SmoothRows& f, int x, int y, float nx, float ny, float magnitude) {
  constexpr float kLargestEcho = 0.2F, kRamp = 0.4F;
  const float left = beside(f, x, y, nx, ny, -3), right = beside(f, x, y, nx, ny, 3);
  if (std::min(left, right) > kRamp * magnitude) return true;
  const float echo_of =
      std::min({left, right, beside(f, x, y, nx, ny, -2), beside(f, x, y, nx, ny, 2)});
  return magnitude < -kLargestEcho * echo_of;
}

}  // namespace

void EdgelMap::add(int x, int y, const Edgel& edgel) {
  const std::size_t word = word_of(x, y);
  if (taken_[word] == 0) first_[word] = static_cast<std::int32_t>(edgels.size());
  taken_[word] |= std::uint64_t{1} << (x % 64);
  edgels.push_back(edgel);
}

EdgelMap find_edgels(const ViewFeatures& features, const EdgelOptions& options) {
  EdgelMap out(features.width, features.height);
  out.noise = estimate_noise(features, options.noise_floor);
  const float weakest = options.weakest * out.noise;
  SmoothRows rows(features);
  const int last_column = features.width - 2;
  // Two pixels in from the border: the outermost gradients are 0 by the border rule.
  for (int y = 2; y + 2 < features.height; ++y) {
    rows.move_to(y);
    const SmoothRow& row = rows.row(y);
    const float* magnitude = row.magnitude.data();
    for (int x = 2; x < last_column; ++x) {
      const float m = magnitude[x];
      if (m < weakest) continue;
      const auto i = static_cast<std::size_t>(x);
      const Across a = sample_across(rows, i, y, row.gx[i], row.gy[i]);
      if (m < a.ahead || m <= a.behind) continue;
      const float nx = row.gx[i] / m, ny = row.gy[i] / m;
      if (is_spurious(rows, x, y, nx, ny, m)) continue;
      const float curvature = a.ahead - 2 * m + a.behind;
      const float offset = a.length * 0.5F * (a.behind - a.ahead) / std::min(curvature, -1e-6F);
      const float shift = std::clamp(offset, -1.0F, 1.0F);
      out.add(x, y,
              {static_cast<float>(x) + shift * nx, static_cast<float>(y) + shift * ny, nx, ny,
               m / out.noise});
    }
  }
  return out;
}

}  // namespace trihedron
