// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/surface_attributes.hpp"

namespace trihedron {

/// A scene surface identified as a model surface.
struct PaperMatch {
  int scene_surface = 0;
  int model_surface = 0;
};

/// A sequence of surface pairs that closes on its first surface. Its surfaces are the identified
/// ones.
struct PaperSequence {
  std::vector<PaperMatch> matches;  ///< in the order of the path, lowest scene surface first
  double error = 0;                 ///< of its pairs, summed, each in units of the tolerances
  bool truncated = false;           ///< the search ended early; a better path may exist
};

/// How far the pair (a, b) of scene surfaces differs from the pair (v, w) of model surfaces in the
/// angle of the normals (eq. 21) and the distance of the centroids (eq. 22): the larger of the two
/// differences in units of its tolerance, so <= 1 when they agree. Eq. 22 as |d - D| <= 0.10 D,
/// which concentric surfaces cannot divide by zero.
double pair_error(const SurfaceAttributes& a, const SurfaceAttributes& b,
                  const SurfaceAttributes& v, const SurfaceAttributes& w);

/// The best path of the search tree of one model: the longest closed sequence in which every pair
/// of neighbours agrees and no surface occurs twice; of several, that with the smallest error.
/// `candidates[i]` are the model surfaces that scene surface i may be. Empty when not even two
/// surfaces agree.
PaperSequence best_sequence(const std::vector<SurfaceAttributes>& scene,
                            const std::vector<SurfaceAttributes>& model,
                            const std::vector<std::vector<int>>& candidates);

}  // namespace trihedron
