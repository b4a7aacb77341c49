// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/index.hpp"
#include "recognition/model.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

/// A model that might stand in the scene, and where.
struct PoseHypothesis {
  int model = 0;               ///< index into the library (not Model::id)
  Transform world_from_model;  ///< mm
  double support = 0;          ///< larger is likelier; comparable within one scene only
};

struct HypothesisOptions {
  double length_tolerance_px = 6;    ///< of an edge with two agreed ends: both ends are rounded
  double angle_tolerance_rad = 0.1;  ///< between two measured directions
  /// Poses from whole edges whose samples hit segments this often keep their segments from being
  /// searched for corners: a wrong pose shares some edges with the truth, rarely most.
  double claim_share = 0.7;
  /// Model corners that are tried on an observed one, those first for whose three edges most
  /// speaks. Of ten models no more pass; with 1000 of ten kinds, all alike, the true one is among
  /// them at 8 to 9 of 10 corners with a whole edge (an object shows dozens), at 2 to 6 of 10
  /// others.
  int best_corners = 200;
  bool table = true;     ///< nothing lies below the world's z = 0
  int max_coarse = 400;  ///< poses that are refined and scored finely
  int max_hypotheses = 400;
};

struct HypothesisStatistics {
  int offered = 0;   ///< poses from all sources
  int scored = 0;    ///< of them not hopeless and not nearly equal to others
  int distinct = 0;  ///< after refinement and merging
};

/// Poses of the library's models that explain some of the crossed edges, likeliest first.
std::vector<PoseHypothesis> find_hypotheses(const std::vector<ViewLines>& views,
                                            const std::vector<SpaceEdge>& edges,
                                            const std::vector<Model>& library,
                                            const LibraryIndex& index,
                                            const HypothesisOptions& options = {},
                                            HypothesisStatistics* statistics = nullptr);

}  // namespace trihedron
