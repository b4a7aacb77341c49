// SPDX-License-Identifier: Apache-2.0
#include "recognition/candidates.hpp"

#include <algorithm>

namespace trihedron {
namespace {

/// Hypotheses nearer than this refine to the same pose, mm.
constexpr double kSameHypothesisMm = 3.0;

double vertex_distance(const Model& model, const Transform& a, const Transform& b) {
  double sum = 0;
  for (const Eigen::Vector3d& v : model.mesh.vertices) sum += (a * v - b * v).norm();
  return sum / static_cast<double>(model.mesh.vertices.size());
}

Eigen::Vector3d vertex_mean(const Model& model, const Transform& pose) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : model.mesh.vertices) sum += v;
  return pose * (sum / static_cast<double>(model.mesh.vertices.size()));
}

}  // namespace

double pose_distance(const Model& model, const Transform& a, const Transform& b) {
  double best = vertex_distance(model, a, b);
  for (const Transform& symmetry : model.symmetries) {
    best = std::min(best, vertex_distance(model, a, b * symmetry));
  }
  return best;
}

double lowest(const Model& model, const Transform& world_from_model) {
  double least = 1e300;
  for (const Eigen::Vector3d& v : model.mesh.vertices) {
    least = std::min(least, (world_from_model * v).z());
  }
  return least;
}

Ranker::Ranker(const SceneInput& input, double floor_mm) : input_(input), floor_mm_(floor_mm) {
  update();
}

void Ranker::update() {
  predictions_.reserve(input_.hypotheses.size());
  for (std::size_t i = predictions_.size(); i < input_.hypotheses.size(); ++i) {
    const PoseHypothesis& h = input_.hypotheses[i];
    const Model& model = input_.library[h.model];
    predictions_.push_back({{}, vertex_mean(model, h.world_from_model)});
    if (lowest(model, h.world_from_model) < floor_mm_) continue;
    predictions_.back().points = glance_points(input_.views, model, h.world_from_model);
  }
}

bool Ranker::same(int a, int b) const {
  const PoseHypothesis &p = input_.hypotheses[a], &q = input_.hypotheses[b];
  // The means are never farther apart than the vertices are on average.
  return p.model == q.model &&
         (predictions_[a].vertex_mean - predictions_[b].vertex_mean).norm() < kSameHypothesisMm &&
         pose_distance(input_.library[p.model], p.world_from_model, q.world_from_model) <
             kSameHypothesisMm;
}

std::vector<RankedHypothesis> Ranker::rank(const GlanceScorer& scorer, int count) const {
  std::vector<RankedHypothesis> ranked;
  for (int i = 0; i < static_cast<int>(predictions_.size()); ++i) {
    const double score = scorer.score(predictions_[i].points);
    if (score >= kLeastAtAGlance) ranked.push_back({score, i});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  std::vector<RankedHypothesis> out;
  for (const RankedHypothesis& r : ranked) {
    if (static_cast<int>(out.size()) >= count) break;
    const bool known = std::any_of(out.begin(), out.end(), [&](const RankedHypothesis& better) {
      return same(better.hypothesis, r.hypothesis);
    });
    if (!known) out.push_back(r);
  }
  return out;
}

Candidate make_candidate(const SceneInput& input, int index,
                         const std::vector<PlacedModel>& known) {
  const PoseHypothesis& hypothesis = input.hypotheses[index];
  return make_candidate(input, hypothesis.model, hypothesis.world_from_model, kHypothesisReachesMm,
                        known);
}

Candidate make_candidate(const SceneInput& input, int model_index,
                         const Transform& world_from_model, const std::vector<double>& reaches_mm,
                         const std::vector<PlacedModel>& known) {
  RefinementOptions options;
  options.reaches_mm = reaches_mm;
  options.exact_rounds = 1;
  std::vector<PlacedModel> scene = known;
  const auto index = static_cast<int>(scene.size());
  scene.push_back({&input.library[model_index], world_from_model});
  Candidate out;
  out.model = model_index;
  out.pose = refine(input.views, scene, index, options);
  scene.back().world_from_model = out.pose.world_from_model;
  VerificationOptions verification;
  verification.tests = std::max<double>(1, static_cast<double>(input.hypotheses.size()));
  out.alone = verify(input.views, input.maps, scene, index,
                     collect_evidence(input.views, scene, index), verification);
  out.verdict = out.alone;
  return out;
}

}  // namespace trihedron
