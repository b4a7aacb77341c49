// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper_hypotheses.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// Relative to the model's value (eqs. 16-19).
constexpr double kAttributeTolerance = 0.20;

bool agrees(double scene, double model) {
  return std::abs(scene - model) <= kAttributeTolerance * model;
}

}  // namespace

PaperModel paper_model(const Model& model) {
  PaperModel out;
  for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
    out.surfaces.push_back(surface_attributes(model, static_cast<int>(i)));
    const SurfaceAttributes& s = out.surfaces.back();
    out.min_area = i == 0 ? s.area : std::min(out.min_area, s.area);
    out.max_area = std::max(out.max_area, s.area);
    out.min_edges = i == 0 ? s.edges() : std::min(out.min_edges, s.edges());
    out.max_edges = std::max(out.max_edges, s.edges());
  }
  return out;
}

bool passes_pretest(const SurfaceAttributes& scene, const PaperModel& model) {
  return scene.area >= (1 - kAttributeTolerance) * model.min_area &&
         scene.area <= (1 + kAttributeTolerance) * model.max_area &&
         scene.edges() >= model.min_edges && scene.edges() <= model.max_edges;
}

bool surfaces_match(const SurfaceAttributes& scene, const SurfaceAttributes& model) {
  if (!agrees(scene.area, model.area) || !agrees(scene.perimeter, model.perimeter) ||
      !agrees(scene.edges(), model.edges())) {
    return false;
  }
  for (const double length : scene.edge_lengths) {
    for (const double model_length : model.edge_lengths) {
      if (agrees(length, model_length)) return true;
    }
  }
  return false;
}

std::vector<PaperHypothesis> paper_hypotheses(const SurfaceAttributes& scene,
                                              const std::vector<PaperModel>& library) {
  std::vector<PaperHypothesis> hypotheses;
  for (std::size_t k = 0; k < library.size(); ++k) {
    if (!passes_pretest(scene, library[k])) continue;
    PaperHypothesis hypothesis{static_cast<int>(k), {}};
    for (std::size_t i = 0; i < library[k].surfaces.size(); ++i) {
      if (!surfaces_match(scene, library[k].surfaces[i])) continue;
      hypothesis.surfaces.push_back(static_cast<int>(i));
    }
    if (!hypothesis.surfaces.empty()) hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace trihedron
