// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "recognition/paper_support.hpp"
#include "recognition/paper_verification.hpp"
#include "recognition/surface_attributes.hpp"
#include "recognition/surfaces.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

/// Eqs. 23 and 24: the motion that brings the model surface's centroid and normal onto the scene
/// surface's, then turns about that normal until the direction from the centroid to the middle of
/// `model_edge` is that to the middle of `scene_edge`. The turn is signed; for opposite normals,
/// where n_m x n_c vanishes, the first turn is about any axis across the normal.
Transform position_surface(const SurfaceAttributes& scene, int scene_edge,
                           const SurfaceAttributes& model, int model_edge);

/// A model put into the scene by some of its surfaces.
struct PaperPosition {
  Transform world_from_model;
  double error_mm = 0;  ///< mean distance between scene vertices and the model's, the paper's d
  CornerSupport support;

  /// More corners explained, then the smaller error.
  bool better_than(const PaperPosition& o) const {
    const int here = support.explained, there = o.support.explained;
    return here != there ? here > there : error_mm < o.error_mm;
  }
};

/// A scene as positioning sees it.
struct PaperScene {
  std::vector<SurfaceAttributes> surfaces;
  std::vector<std::vector<SpacePolygon>> loops;  ///< of the surfaces, world, mm
  MeasuredCorners corners;                       ///< of all regions
  double error_mm = 0;                           ///< the Error of data crossing

  /// How far a model vertex may be from a corner that it explains: one Error for the corner, the
  /// rest for the position, which one centroid and one edge fix.
  double tolerance_mm() const { return 3 * error_mm; }
};

/// Positions a model by each of the matched surfaces and each pair of their edges that eq. 19
/// matches; returns the best of those positions whose error over all matched surfaces is at most
/// 10 % of the model's smallest dimension. A scene vertex's partner is the nearest vertex of its
/// model surface. Empty when there is no such position.
std::optional<PaperPosition> position_model(const PaperScene& scene, const Model& model,
                                            const std::vector<SurfaceAttributes>& model_surfaces,
                                            const PaperSequence& matches);

/// The smallest distance of two parallel planes, one along a surface, that hold the model between
/// them, mm.
double smallest_dimension_mm(const Model& model);

}  // namespace trihedron
