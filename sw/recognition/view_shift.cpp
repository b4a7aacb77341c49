// SPDX-License-Identifier: Apache-2.0
#include "recognition/view_shift.hpp"

#include <Eigen/LU>
#include <cmath>

namespace trihedron {

Eigen::Vector2d view_shift(const ContourField& field, const std::vector<EdgePoint>& points) {
  /// Half widths of the bands around the shift so far in which contours count, px.
  constexpr double kBandsPx[] = {4, 2.5, 1.5, 1.5};
  /// Contours are whole pixels: what they say of a shift is worth so many square pixels of doubt
  /// about calibration. Directions without edges stay where they are.
  constexpr double kPrior = 4;
  struct Found {
    Eigen::Vector2d normal;
    double distance;  // px
  };
  std::vector<Found> found;
  for (const EdgePoint& p : points) {
    const double d = field.nearest_contour(p.x, p.normal, kBandsPx[0]);
    if (!std::isnan(d)) found.push_back({p.normal, d});
  }
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  for (const double band : kBandsPx) {
    Eigen::Matrix2d A = kPrior * Eigen::Matrix2d::Identity();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (const Found& f : found) {
      const double z = (f.distance - f.normal.dot(shift)) / band;
      if (std::abs(z) >= 1) continue;
      const double weight = (1 - z * z) * (1 - z * z);
      A += weight * f.normal * f.normal.transpose();
      b += weight * f.distance * f.normal;
    }
    shift = A.inverse() * b;
  }
  const double length = shift.norm();
  return length > kMostShiftPx ? Eigen::Vector2d(kMostShiftPx / length * shift) : shift;
}

}  // namespace trihedron
