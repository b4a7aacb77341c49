// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "recognition/paper_verification.hpp"
#include "recognition/surface_attributes.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

/// Eqs. 23 and 24: the motion that brings the model surface's centroid and normal onto the scene
/// surface's, then turns about that normal until the direction from the centroid to the middle of
/// `model_edge` is that to the middle of `scene_edge`. The turn is signed; for opposite normals,
/// where n_m x n_c vanishes, the first turn is about any axis across the normal.
Transform position_surface(const SurfaceAttributes& scene, int scene_edge,
                           const SurfaceAttributes& model, int model_edge);

struct PaperPosition {
  Transform world_from_model;
  double error_mm = 0;    ///< mean distance between scene vertices and the model's, the paper's d
  PaperMatch reference;   ///< the surface that fixed the position
};

/// Positions a model by each identified surface and each pair of its edges that eq. 19 matches,
/// and returns the position with the smallest error over all identified surfaces. A scene
/// vertex's partner is the nearest vertex of its model surface. Empty without matches or edges
/// that match.
std::optional<PaperPosition> position_model(const std::vector<SurfaceAttributes>& scene,
                                            const std::vector<std::vector<SpacePolygon>>& loops,
                                            const Model& model,
                                            const std::vector<SurfaceAttributes>& model_surfaces,
                                            const std::vector<PaperMatch>& matches);

}  // namespace trihedron
