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

/// The surfaces of a sequence of pairs that closes on its first surface, ascending in scene
/// surface: the identified ones, if the sequence is chosen.
using PaperSequence = std::vector<PaperMatch>;

/// How far the pair (a, b) of scene surfaces differs from the pair (v, w) of model surfaces in the
/// angle of the normals (eq. 21) and the distance of the centroids (eq. 22): the larger of the two
/// differences in units of its tolerance, so <= 1 when they agree. Eq. 22 as |d - D| <= 0.10 D,
/// which concentric surfaces cannot divide by zero.
double pair_error(const SurfaceAttributes& a, const SurfaceAttributes& b,
                  const SurfaceAttributes& v, const SurfaceAttributes& w);

struct SequenceSearch {
  std::vector<PaperSequence> sequences;  ///< longest first, each set of surfaces once
  bool truncated = false;                ///< the search ended early; more may exist
};

/// The search tree of one model: all closed sequences in which every pair of neighbours agrees
/// (pair_error <= 1) and no surface occurs twice. `candidates[i]` are the model surfaces that
/// scene surface i may be. Empty when not even two surfaces agree.
SequenceSearch closed_sequences(const std::vector<SurfaceAttributes>& scene,
                                const std::vector<SurfaceAttributes>& model,
                                const std::vector<std::vector<int>>& candidates);

}  // namespace trihedron
