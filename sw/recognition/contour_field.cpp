// SPDX-License-Identifier: Apache-2.0
#include "recognition/contour_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace trihedron {
namespace {

/// Standard deviation that rounding to 8 bits gives a gradient component, grey levels per px:
/// uniform rounding noise of 1/sqrt(12) through the spline derivative's taps [1 -6 0 6 -1] / 8.
constexpr double kRoundingNoise = 0.29 * 1.075;
/// A standard normal variable's median magnitude.
constexpr double kMedianOfNormal = 0.6745;
/// Half width of the bell that weights a profile, px: covers a blurred edge's gradient (the
/// derivative's own 2 px and a blur of about 1 px) and leaves out lines 4 px away.
constexpr float kBellPx = 3;

/// An edge's centre is followed so far, px.
constexpr float kMostOffsetPx = 2;

/// Smooth, symmetric, 0 from kBellPx on.
float bell(float u) {
  const float v = 1 - u * u * (1 / (kBellPx * kBellPx));
  return v > 0 ? v * v : 0;
}

using Lanes __attribute__((vector_size(16))) = float;

Lanes bell(const Lanes& u) {
  const Lanes v = 1 - u * u * (1 / (kBellPx * kBellPx));
  return v > 0 ? v * v : Lanes{};
}
Lanes load(const float* from) {
  Lanes out;
  std::memcpy(&out, from, sizeof out);
  return out;
}
float total(const Lanes& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace

ContourField::ContourField(const ViewFeatures& features)
    : ContourField(features, find_edgels(features)) {}

ContourField::ContourField(const ViewFeatures& features, const EdgelMap& edgels)
    : features_(&features), width_(features.width), height_(features.height) {
  constexpr std::size_t kStride = 29;  // a sample of the pixels will do, prime to most widths
  std::vector<int> magnitudes;
  for (std::size_t i = 0; i < features.contour.size(); i += kStride) {
    magnitudes.push_back(std::abs(features.contour[i].gx));
    magnitudes.push_back(std::abs(features.contour[i].gy));
  }
  if (!magnitudes.empty()) {
    const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
    std::nth_element(magnitudes.begin(), middle, magnitudes.end());
    noise_ = *middle / kMedianOfNormal;
  }
  noise_ = std::max(noise_, kRoundingNoise * kGradientScale);
  build_bins(clear_contour(features, edgels.noise));
}

int ContourField::bin_of(double gx, double gy) {
  if (gy < 0) {
    gx = -gx;
    gy = -gy;
  }
  // The direction lies in [0, 180) degrees; bin 0 is centred on the x axis.
  constexpr double kT1 = 0.19891236737965800;  // tan 11.25 degrees
  constexpr double kT3 = 0.66817863791929892;  // tan 33.75 degrees
  const double ax = std::abs(gx);
  int bin;
  if (gy <= kT1 * ax) {
    bin = 0;
  } else if (gy <= kT3 * ax) {
    bin = 1;
  } else if (ax >= kT3 * gy) {
    bin = 2;
  } else if (ax >= kT1 * gy) {
    bin = 3;
  } else {
    return 4;
  }
  return gx >= 0 || bin == 0 ? bin : kBins - bin;
}

void ContourField::build_bins(const std::vector<ContourPixel>& contour) {
  bins_.assign(features_->contour.size(), 0);
  for (const ContourPixel& pixel : contour) {
    while (static_cast<int>(rows_.size()) <= pixel.y) {
      rows_.push_back(static_cast<int>(pixels_.size()));
    }
    const ContourBeat& beat = features_->at(pixel.x, pixel.y);
    const auto bin = static_cast<std::uint8_t>(bin_of(beat.gx, beat.gy));
    bins_[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width_) +
          static_cast<std::size_t>(pixel.x)] = static_cast<std::uint8_t>(1U << bin);
    pixels_.push_back({pixel.x, pixel.y, bin});
  }
  rows_.resize(static_cast<std::size_t>(height_) + 1, static_cast<int>(pixels_.size()));
}

/// A walk in whole steps along the normal's longer component visits every row (or column) once and
/// looks at two neighbours in it, so that it cannot slip through a one-pixel-wide contour.
template <typename Visit>
void ContourField::walk(const Eigen::Vector2d& x, const Eigen::Vector2d& normal, double reach_px,
                        Visit visit) const {
  const int bin = bin_of(normal.x(), normal.y());
  const unsigned accepted =
      1U << bin | 1U << ((bin + 1) % kBins) | 1U << ((bin + kBins - 1) % kBins);
  const bool along_x = std::abs(normal.x()) >= std::abs(normal.y());
  // "long" and "side": the coordinates along the longer component of the normal and the other one.
  const int side_axis = along_x ? 1 : 0;
  const double longer = normal[1 - side_axis], per_px = 1 / std::abs(longer);
  const double side_step = normal[side_axis] * per_px;
  const int long_step = longer > 0 ? 1 : -1;
  const int long_start = static_cast<int>(std::floor(x[1 - side_axis] + 0.5));
  const int long_end = (along_x ? width_ : height_) - 1;
  const double side_end = (along_x ? height_ : width_) - 1;
  const int long_stride = along_x ? 1 : width_, side_stride = along_x ? width_ : 1;
  const int steps = static_cast<int>(reach_px * std::abs(longer));
  for (int i = 0; i <= 2 * steps; ++i) {
    const int k = (i & 1) ? (i + 1) / 2 : -i / 2;
    const int at_long = long_start + k * long_step;
    const double at_side = x[side_axis] + k * side_step;
    if (at_long < 0 || at_long >= long_end || !(at_side >= 0 && at_side < side_end)) continue;
    const int first = static_cast<int>(at_side);
    const std::uint8_t* place = bins_.data() + at_long * long_stride + first * side_stride;
    const bool here = (place[0] & accepted) != 0;
    if (!here && !(place[side_stride] & accepted)) continue;
    const double d = longer * (at_long - x[1 - side_axis]) +
                     normal[side_axis] * (first + (here ? 0 : 1) - x[side_axis]);
    if (!visit(d)) return;
  }
}

double ContourField::nearest_contour(const Eigen::Vector2d& x, const Eigen::Vector2d& normal,
                                     double reach_px) const {
  double nearest = std::numeric_limits<double>::quiet_NaN();
  walk(x, normal, reach_px, [&](double d) {
    nearest = d;
    return false;
  });
  return nearest;
}

void ContourField::contours_across(const Eigen::Vector2d& x, const Eigen::Vector2d& normal,
                                   double reach_px, std::vector<double>& out) const {
  out.clear();
  walk(x, normal, reach_px, [&](double d) {
    out.push_back(d);
    return true;
  });
}

void ContourField::gradients_along(const Eigen::Vector2d& x, const Eigen::Vector2d& normal,
                                   int first, int last, float* out) const {
  const auto nx = static_cast<float>(normal.x()), ny = static_cast<float>(normal.y());
  const auto along = [&](const ContourBeat& beat) {
    return nx * static_cast<float>(beat.gx) + ny * static_cast<float>(beat.gy);
  };
  for (int i = first; i <= last; ++i) {
    const double px = x.x() + i * normal.x(), py = x.y() + i * normal.y();
    const int ix = static_cast<int>(px), iy = static_cast<int>(py);
    const auto fx = static_cast<float>(px - ix), fy = static_cast<float>(py - iy);
    const ContourBeat* a = features_->contour.data() + iy * width_ + ix;
    const ContourBeat* b = a + width_;
    const float a0 = along(a[0]), a1 = along(a[1]), b0 = along(b[0]), b1 = along(b[1]);
    const float above = a0 + fx * (a1 - a0), below = b0 + fx * (b1 - b0);
    *out++ = above + fy * (below - above);
  }
}

float ContourField::step(const float* gradients) const {
  float sum = 0, squares = 0;
  for (int u = -kStepReach; u <= kStepReach; ++u) {
    const float w = bell(static_cast<float>(u));
    sum += w * gradients[u];
    squares += w * w;
  }
  return sum / (static_cast<float>(noise_) * std::sqrt(squares));
}

namespace {

constexpr int kProfileReach = 5;  // the bell's half width and as far as it moves

/// Gradients along a normal, known from `first` up to `last`. The bell covers at most 7 of them:
/// two registers' worth from its first one on.
struct ProfileSamples {
  std::array<float, 2 * kProfileReach + 2> g{};
  int first = kProfileReach, last = kProfileReach - 1;

  /// Takes what is not known yet from `low` to `high`: take(from, to, out), counted from the
  /// middle.
  template <typename Take>
  void reach(int low, int high, const Take& take) {
    if (low < first) take(low - kProfileReach, first - 1 - kProfileReach, &g[low]);
    if (high > last) take(last + 1 - kProfileReach, high - kProfileReach, &g[last + 1]);
    first = std::min(first, low);
    last = std::max(last, high);
  }
};

}  // namespace

EdgeProfile ContourField::profile(const Eigen::Vector2d& x, const Eigen::Vector2d& normal) const {
  constexpr int kRounds = 4;
  constexpr float kSettledPx = 1e-3F;
  const auto take = [&](int from, int to, float* out) {
    gradients_along(x, normal, from, to, out);
  };
  ProfileSamples samples;
  const auto noise = static_cast<float>(noise_);
  float centre = 0, sum = 0;
  Lanes u[2], w[2];
  for (int round = 0; round < kRounds; ++round) {
    // The centre of gravity under a bell that follows it: unbiased for any symmetric blur.
    const float start = kProfileReach + centre - kBellPx;  // at least 0
    const int low = static_cast<int>(start) + (static_cast<float>(static_cast<int>(start)) < start);
    // Samples outside the bell need not be taken: most edges are near the point.
    samples.reach(low, static_cast<int>(kProfileReach + centre + kBellPx), take);
    u[0] = Lanes{0, 1, 2, 3} + (static_cast<float>(low - kProfileReach) - centre);
    u[1] = u[0] + 4;
    Lanes weighted{}, moment{};
    for (int k = 0; k < 2; ++k) {
      w[k] = bell(u[k]);
      const Lanes wg = w[k] * load(&samples.g[low + 4 * k]);
      weighted += wg;
      moment += wg * u[k];
    }
    sum = total(weighted);
    if (std::abs(sum) < noise) break;
    const float before = centre;
    centre = std::clamp(centre + total(moment) / sum, -kMostOffsetPx, kMostOffsetPx);
    if (std::abs(centre - before) < kSettledPx) break;
  }
  const Lanes squares = w[0] * w[0] + w[1] * w[1];
  const Lanes spread = w[0] * w[0] * u[0] * u[0] + w[1] * w[1] * u[1] * u[1];
  EdgeProfile out;
  out.offset_px = centre;
  out.height = sum;
  out.sigma_height = noise * std::sqrt(total(squares));
  out.sigma_px = noise * std::sqrt(total(spread)) / std::max(std::abs(sum), 1e-9F);
  return out;
}

}  // namespace trihedron
