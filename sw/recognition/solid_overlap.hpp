// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/model.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

/// Points inside a model, on a grid, none nearer than `margin_mm` to its surface: what two
/// solids must not share.
struct InnerPoints {
  std::vector<Eigen::Vector3d> points;  ///< model frame, mm
};

InnerPoints inner_points(const Model& model, double margin_mm);

/// Whether `x` (model frame, mm) lies inside the model.
bool inside(const Model& model, const Eigen::Vector3d& x);

/// Whether two placed models fill the same space by more than their inner points' margin.
bool overlap(const PlacedModel& a, const InnerPoints& inner_a, const PlacedModel& b,
             const InnerPoints& inner_b);

}  // namespace trihedron
