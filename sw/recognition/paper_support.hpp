// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recognition/model.hpp"
#include "recognition/surfaces.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

/// How well the reconstructed model fits the corners of the views' regions.
struct CornerSupport {
  int explained = 0;  ///< corners that a model vertex projects onto
  int inside = 0;     ///< corners inside the model's outline in their view, those included
  int outline = 0;    ///< corners of the outlines
  int found = 0;      ///< those of them that project onto a corner of a region

  /// At most 20 % of the corners inside the outlines are left over, the paper's tolerance for a
  /// match of attributes.
  bool consistent() const { return explained > 0 && 5 * explained >= 4 * inside; }
  /// Two thirds of the outlines' corners are there: the object may be hidden in one view of three.
  bool outlined() const { return 3 * found >= 2 * outline; }
};

/// Counts over all three views. The outline of a view is the convex hull of the projected
/// vertices. A vertex projects onto a corner when the coordinates that the view measures agree
/// within `tolerance_mm`.
CornerSupport corner_support(const MeasuredCorners& corners, const Model& model,
                             const Transform& world_from_model, double tolerance_mm);

/// The corners that no vertex of the model projects onto.
MeasuredCorners unexplained_corners(const MeasuredCorners& corners, const Model& model,
                                    const Transform& world_from_model, double tolerance_mm);

}  // namespace trihedron
