// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "golden/features.hpp"
#include "recognition/clear_contour.hpp"
#include "recognition/edgels.hpp"

namespace trihedron {

/// What an image line looks like in the gradient, across it.
struct EdgeProfile {
  double offset_px = 0;     ///< of the edge from the point asked for, along the normal
  double height = 0;        ///< grey step across the edge, gradient units * px, signed: positive
                            ///< when the grey level grows along the normal
  double sigma_height = 1;  ///< standard deviation of `height` by image noise alone
  double sigma_px = 1;      ///< standard deviation of `offset_px` by image noise alone
};

/// One view's contour stream, as far as it stands above its noise (clear_contour.hpp), prepared for
/// questions along predicted image lines. Directions are of the gradient, modulo 180 degrees: a
/// predicted line does not know which side is brighter.
class ContourField {
 public:
  static constexpr int kBins = 8;  ///< of 22.5 degrees

  explicit ContourField(const ViewFeatures& features);
  /// The same with the view's edge points, where they are known already.
  ContourField(const ViewFeatures& features, const EdgelMap& edgels);
  explicit ContourField(ViewFeatures&&) = delete;  // it would not outlive the field

  int width() const { return width_; }
  int height() const { return height_; }
  /// Standard deviation of a gradient component where the image is flat, from its median
  /// magnitude: image noise and texture, at least that of rounding to 8 bits.
  double noise() const { return noise_; }
  /// A pixel of the contour and its direction's bin.
  struct Pixel {
    std::int16_t x, y;
    std::uint8_t bin;
  };
  /// All contour pixels in raster order.
  const std::vector<Pixel>& pixels() const { return pixels_; }
  /// Those of row y: [first, second).
  std::pair<int, int> row(int y) const { return {rows_[y], rows_[y + 1]}; }

  bool inside(const Eigen::Vector2d& x, double margin_px) const {
    return x.x() >= margin_px && x.y() >= margin_px && x.x() <= width_ - 1 - margin_px &&
           x.y() <= height_ - 1 - margin_px;
  }
  /// Direction bins of the contour pixel at (x, y), as a bit mask; 0: no contour.
  std::uint8_t directions(int x, int y) const { return bins_[y * width_ + x]; }

  /// The contour nearest to `x` along `normal` within `reach_px`, whose direction agrees within
  /// about 30 degrees: its distance in px along the normal, or nothing (NaN).
  double nearest_contour(const Eigen::Vector2d& x, const Eigen::Vector2d& normal,
                         double reach_px) const;
  /// All contours along `normal` within `reach_px` whose direction agrees within about 30
  /// degrees: their distances in px, nearest first, into `out`.
  void contours_across(const Eigen::Vector2d& x, const Eigen::Vector2d& normal, double reach_px,
                       std::vector<double>& out) const;
  /// The edge within about 1.5 px of `x` across `normal`, to a small part of a pixel. The point
  /// must lie kProfilePx inside the image.
  EdgeProfile profile(const Eigen::Vector2d& x, const Eigen::Vector2d& normal) const;
  /// The gradient's components along `normal` at x + i * normal for i from `first` to `last`, all
  /// of them inside the image, between the pixels; image units.
  void gradients_along(const Eigen::Vector2d& x, const Eigen::Vector2d& normal, int first, int last,
                       float* out) const;
  static constexpr int kStepReach = 2;
  /// The grey step across a point, in standard deviations of image noise, signed: from the
  /// gradients along the normal there, `gradients`[0], and kStepReach px to either side.
  float step(const float* gradients) const;

  static constexpr double kProfilePx = 6;
  /// The bin of a gradient direction.
  static int bin_of(double gx, double gy);

 private:
  template <typename Visit>
  void walk(const Eigen::Vector2d& x, const Eigen::Vector2d& normal, double reach_px,
            Visit visit) const;
  void build_bins(const std::vector<ContourPixel>& contour);

  const ViewFeatures* features_;
  int width_ = 0, height_ = 0;
  double noise_ = 0;
  std::vector<std::uint8_t> bins_;
  std::vector<Pixel> pixels_;
  std::vector<int> rows_;  // per row and one more: index of its first pixel
};

}  // namespace trihedron
