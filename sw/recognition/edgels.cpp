// SPDX-License-Identifier: Apache-2.0
#include "recognition/edgels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace trihedron {
namespace {

/// Two components per pixel and their magnitude, row-major.
struct Field {
  int width, height;
  std::vector<float> gx, gy, magnitude;
};

/// Sum of [1 2 1] / 4 along x and along y; the outermost pixels stay 0 (border rule).
Field smooth(const ViewFeatures& f) {
  const int w = f.width, h = f.height;
  const auto size = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  Field s{w, h, std::vector<float>(size), std::vector<float>(size), std::vector<float>(size)};
  std::vector<float> cx(static_cast<std::size_t>(w)), cy(cx);
  for (int y = 1; y + 1 < h; ++y) {
    const ContourBeat* up = &f.at(0, y - 1);
    const ContourBeat* mid = &f.at(0, y);
    const ContourBeat* down = &f.at(0, y + 1);
    for (int x = 0; x < w; ++x) {
      const auto i = static_cast<std::size_t>(x);
      cx[i] = static_cast<float>(up[x].gx + 2 * mid[x].gx + down[x].gx);
      cy[i] = static_cast<float>(up[x].gy + 2 * mid[x].gy + down[x].gy);
    }
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(w);
    for (std::size_t x = 1; x + 1 < static_cast<std::size_t>(w); ++x) {
      const float a = (cx[x - 1] + 2 * cx[x] + cx[x + 1]) / 16;
      const float b = (cy[x - 1] + 2 * cy[x] + cy[x + 1]) / 16;
      s.gx[row + x] = a;
      s.gy[row + x] = b;
      s.magnitude[row + x] = std::sqrt(a * a + b * b);
    }
  }
  return s;
}

/// Sigma of one gradient component from the median of a Rayleigh distributed magnitude.
float estimate_noise(const std::vector<float>& magnitude, float floor) {
  std::vector<float> sample;
  sample.reserve(magnitude.size() / 7 + 1);
  for (std::size_t i = 0; i < magnitude.size(); i += 7) sample.push_back(magnitude[i]);
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

Across sample_across(const Field& f, std::size_t i, float gx, float gy) {
  const auto w = static_cast<std::ptrdiff_t>(f.width);
  const bool flat = std::abs(gx) >= std::abs(gy);
  const float major = flat ? gx : gy, minor = flat ? gy : gx;
  const float slope = std::abs(minor / major);
  const std::ptrdiff_t step = flat ? (gx > 0 ? 1 : -1) : (gy > 0 ? w : -w);
  const std::ptrdiff_t side = flat ? (gy > 0 ? w : -w) : (gx > 0 ? 1 : -1);
  const float* m = f.magnitude.data() + i;
  return {m[step] * (1 - slope) + m[step + side] * slope,
          m[-step] * (1 - slope) + m[-step - side] * slope, std::sqrt(1 + slope * slope)};
}

/// Smoothed gradient along (nx, ny) at the pixel nearest to (x, y) + step * (nx, ny).
float beside(const Field& f, int x, int y, float nx, float ny, float step) {
  const int px = static_cast<int>(std::lround(static_cast<float>(x) + step * nx));
  const int py = static_cast<int>(std::lround(static_cast<float>(y) + step * ny));
  if (px < 0 || py < 0 || px >= f.width || py >= f.height) return 0;
  const auto i = static_cast<std::size_t>(py) * static_cast<std::size_t>(f.width) +
                 static_cast<std::size_t>(px);
  return f.gx[i] * nx + f.gy[i] * ny;
}

/// Ridges that are no edges of objects. Two to three pixels beside an edge, the derivative's masks
/// overshoot: their response has the opposite sign and up to 1/5 of the edge's. On a ramp wider
/// than the optics' blur, the border of a soft shadow, both sides are nearly as steep.
bool is_spurious(const Field& f, int x, int y, float nx, float ny, float magnitude) {
  constexpr float kLargestEcho = 0.2F, kRamp = 0.4F;
  const float left = beside(f, x, y, nx, ny, -3), right = beside(f, x, y, nx, ny, 3);
  if (std::min(left, right) > kRamp * magnitude) return true;
  const float echo_of =
      std::min({left, right, beside(f, x, y, nx, ny, -2), beside(f, x, y, nx, ny, 2)});
  return magnitude < -kLargestEcho * echo_of;
}

}  // namespace

EdgelMap find_edgels(const ViewFeatures& features, const EdgelOptions& options) {
  EdgelMap out;
  out.width = features.width;
  out.height = features.height;
  out.map.assign(features.contour.size(), -1);
  const Field f = smooth(features);
  out.noise = estimate_noise(f.magnitude, options.noise_floor);
  const float weakest = options.weakest * out.noise;
  // Two pixels in from the border: the outermost gradients are 0 by the border rule.
  for (int y = 2; y + 2 < f.height; ++y) {
    for (int x = 2; x + 2 < f.width; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(f.width) +
                     static_cast<std::size_t>(x);
      const float m = f.magnitude[i];
      if (m < weakest) continue;
      const Across a = sample_across(f, i, f.gx[i], f.gy[i]);
      if (m < a.ahead || m <= a.behind) continue;
      const float nx = f.gx[i] / m, ny = f.gy[i] / m;
      if (is_spurious(f, x, y, nx, ny, m)) continue;
      const float curvature = a.ahead - 2 * m + a.behind;
      const float offset = a.length * 0.5F * (a.behind - a.ahead) / std::min(curvature, -1e-6F);
      const float shift = std::clamp(offset, -1.0F, 1.0F);
      out.map[i] = static_cast<std::int32_t>(out.edgels.size());
      out.edgels.push_back({static_cast<float>(x) + shift * nx, static_cast<float>(y) + shift * ny,
                            nx, ny, m / out.noise});
    }
  }
  return out;
}

}  // namespace trihedron
