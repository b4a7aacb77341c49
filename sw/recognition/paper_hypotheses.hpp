// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/model.hpp"
#include "recognition/surface_attributes.hpp"

namespace trihedron {

/// A model as the paper's library holds it.
struct PaperModel {
  std::vector<SurfaceAttributes> surfaces;  ///< model frame; as many as NF
  double min_area = 0, max_area = 0;        ///< AMIN, AMAX, mm^2
  int min_edges = 0, max_edges = 0;         ///< NLMIN, NLMAX, edges per surface
};

PaperModel paper_model(const Model& model);

/// One entry of V_i (eq. 20): a model and those of its surfaces that a scene surface may be.
struct PaperHypothesis {
  int model = 0;              ///< index into the library
  std::vector<int> surfaces;  ///< ascending, not empty
};

/// Eqs. 14 and 15: are area and edge count of the scene surface in the range of the model's? The
/// area with the tolerance of eq. 16, without which a model's largest and smallest surfaces would
/// fail by the smallest measuring error.
bool passes_pretest(const SurfaceAttributes& scene, const PaperModel& model);

/// Eqs. 16-19: area, perimeter, edge count, and one edge's length against any edge's, each within
/// 20 % of the model's value.
bool surfaces_match(const SurfaceAttributes& scene, const SurfaceAttributes& model);

/// V_i of one scene surface, models in library order.
std::vector<PaperHypothesis> paper_hypotheses(const SurfaceAttributes& scene,
                                              const std::vector<PaperModel>& library);

}  // namespace trihedron
