// SPDX-License-Identifier: Apache-2.0
#include "recognition/contour_field.hpp"

#include <algorithm>
#include <cmath>
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
constexpr double kBellPx = 3.0;

/// Smooth, symmetric, 0 from kBellPx on.
double bell(double u) {
  const double v = 1 - u * u * (1 / (kBellPx * kBellPx));
  return v > 0 ? v * v : 0;
}

}  // namespace

ContourField::ContourField(const ViewFeatures& features)
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
  build_bins(features);
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

void ContourField::build_bins(const ViewFeatures& features) {
  bins_.assign(features.contour.size(), 0);
  constexpr int kTogether = 8;  // most pixels are none: asked for in groups
  const ContourBeat* row = features.contour.data();
  for (int y = 0; y < height_; ++y, row += width_) {
    for (int first = 0; first < width_; first += kTogether) {
      const int end = std::min(first + kTogether, width_);
      unsigned flags = 0;
      for (int x = first; x < end; ++x) flags |= row[x].flags;
      if ((flags & kContour) == 0) continue;
      for (int x = first; x < end; ++x) {
        if (!row[x].contour()) continue;
        const int bin = bin_of(row[x].gx, row[x].gy);
        bins_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(1U << bin);
        pixels_.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                           static_cast<std::uint8_t>(bin)});
      }
    }
  }
}

template <typename Visit>
void ContourField::walk(const Eigen::Vector2d& x, const Eigen::Vector2d& normal, double reach_px,
                        Visit visit) const {
  const int bin = bin_of(normal.x(), normal.y());
  const auto accepted = static_cast<std::uint8_t>((1U << bin) | (1U << ((bin + 1) % kBins)) |
                                                  (1U << ((bin + kBins - 1) % kBins)));
  // A walk in whole steps along the longer component visits every row (or column) once and
  // looks at two neighbours in it, so that it cannot slip through a one-pixel-wide contour.
  const bool along_x = std::abs(normal.x()) >= std::abs(normal.y());
  const double longer = along_x ? normal.x() : normal.y();
  const Eigen::Vector2d step = normal / std::abs(longer);
  const int steps = static_cast<int>(reach_px * std::abs(longer));
  for (int i = 0; i <= 2 * steps; ++i) {
    const int k = (i & 1) ? (i + 1) / 2 : -i / 2;
    const Eigen::Vector2d p = x + k * step;
    const int px = static_cast<int>(std::floor(along_x ? p.x() + 0.5 : p.x()));
    const int py = static_cast<int>(std::floor(along_x ? p.y() : p.y() + 0.5));
    if (px < 0 || py < 0 || px + 1 >= width_ || py + 1 >= height_) continue;
    const std::uint8_t here = directions(px, py) & accepted;
    const std::uint8_t beside = directions(px + !along_x, py + along_x) & accepted;
    if (!here && !beside) continue;
    const Eigen::Vector2d hit(here ? px : px + !along_x, here ? py : py + along_x);
    if (!visit(normal.dot(hit - x))) return;
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

Eigen::Vector2d ContourField::gradient(const Eigen::Vector2d& x) const {
  const int ix = static_cast<int>(x.x()), iy = static_cast<int>(x.y());
  const double fx = x.x() - ix, fy = x.y() - iy;
  const ContourBeat* a = &features_->contour[static_cast<std::size_t>(iy) * width_ + ix];
  const ContourBeat* b = a + width_;
  const double w00 = (1 - fx) * (1 - fy), w10 = fx * (1 - fy), w01 = (1 - fx) * fy, w11 = fx * fy;
  return {w00 * a[0].gx + w10 * a[1].gx + w01 * b[0].gx + w11 * b[1].gx,
          w00 * a[0].gy + w10 * a[1].gy + w01 * b[0].gy + w11 * b[1].gy};
}

double ContourField::step(const Eigen::Vector2d& x, const Eigen::Vector2d& normal) const {
  double sum = 0, squares = 0;
  for (int u = -2; u <= 2; ++u) {
    const double w = bell(u);
    sum += w * normal.dot(gradient(x + u * normal));
    squares += w * w;
  }
  return sum / (noise_ * std::sqrt(squares));
}

EdgeProfile ContourField::profile(const Eigen::Vector2d& x, const Eigen::Vector2d& normal) const {
  constexpr int kReach = 5;
  constexpr int kRounds = 3;
  double g[2 * kReach + 1];  // along the normal; known from `first` up to `last`
  int first = kReach, last = kReach - 1;
  const auto sample = [&](int i) { return normal.dot(gradient(x + (i - kReach) * normal)); };
  EdgeProfile out;
  double centre = 0, sum = 0, squares = 0, spread = 0;
  for (int round = 0; round < kRounds; ++round) {
    // The centre of gravity under a bell that follows it: unbiased for any symmetric blur.
    double moment = 0;
    sum = squares = spread = 0;
    // Samples outside the bell need not be taken: most edges are near the point.
    const int low = std::max(0, static_cast<int>(std::ceil(kReach + centre - kBellPx)));
    const int high = std::min(2 * kReach, static_cast<int>(std::floor(kReach + centre + kBellPx)));
    while (first > low) --first, g[first] = sample(first);
    while (last < high) ++last, g[last] = sample(last);
    for (int i = low; i <= high; ++i) {
      const double u = i - kReach - centre, w = bell(u);
      sum += w * g[i];
      moment += w * g[i] * u;
      squares += w * w;
      spread += w * w * u * u;
    }
    if (std::abs(sum) < noise_) break;
    centre = std::clamp(centre + moment / sum, -2.0, 2.0);
  }
  out.offset_px = centre;
  out.height = sum;
  out.sigma_height = noise_ * std::sqrt(squares);
  out.sigma_px = noise_ * std::sqrt(spread) / std::max(std::abs(sum), 1e-9);
  return out;
}

}  // namespace trihedron
