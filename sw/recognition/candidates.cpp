// SPDX-License-Identifier: Apache-2.0
#include "recognition/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/projected_model.hpp"

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

/// The score of one edge's image.
double score_line(const SpreadMap& map, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  constexpr double kStepPx = 16;             // independent answers
  constexpr double kHit = 0.9, kMiss = 0.1;  // of an edge that is there
  const Eigen::Vector2d along = b - a;
  const int count = static_cast<int>(along.norm() / kStepPx);
  if (count == 0) return 0;
  const int bin = ContourField::bin_of(-along.y(), along.x());
  const double chance = std::clamp(map.density[bin], 0.01, 0.9);
  const double hit = std::log(kHit / chance), miss = std::log(kMiss / (1 - chance));
  const double width = map.columns * SpreadMap::kCellPx, height = map.rows * SpreadMap::kCellPx;
  double score = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d x = a + (i + 0.5) / count * along;
    if (x.x() < 0 || x.y() < 0 || x.x() >= width || x.y() >= height) continue;
    score += map.near(x, bin) ? hit : miss;
  }
  return score;
}

}  // namespace

double pose_distance(const Model& model, const Transform& a, const Transform& b) {
  double best = vertex_distance(model, a, b);
  for (const Transform& symmetry : model.symmetries) {
    best = std::min(best, vertex_distance(model, a, b * symmetry));
  }
  return best;
}

double quick_score(const std::vector<FieldView>& views, const std::vector<SpreadMap>& maps,
                   const Model& model, const Transform& world_from_model) {
  double score = 0;
  std::vector<Eigen::Vector2d> pixels;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Camera& camera = *views[v].camera;
    const ProjectedModel projected = project_model(camera, {&model, world_from_model});
    pixels.clear();
    for (const Eigen::Vector3d& x : projected.x_in_camera) {
      pixels.push_back(camera.project_camera(x));
    }
    for (const ModelEdge& edge : model.edges) {
      const bool left = projected.front[edge.left], right = projected.front[edge.right];
      if ((!left && !right) || (!edge.convex && left != right)) continue;
      score += score_line(maps[v], pixels[edge.v0], pixels[edge.v1]);
    }
  }
  return score;
}

std::vector<RankedHypothesis> rank(const SceneInput& input, const std::vector<SpreadMap>& maps,
                                   int count) {
  std::vector<RankedHypothesis> ranked;
  for (int i = 0; i < static_cast<int>(input.hypotheses.size()); ++i) {
    const PoseHypothesis& h = input.hypotheses[i];
    const double score = quick_score(input.views, maps, input.library[h.model], h.world_from_model);
    if (score > 0) ranked.push_back({score, i});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  std::vector<RankedHypothesis> out;
  std::vector<Eigen::Vector3d> means;
  for (const RankedHypothesis& r : ranked) {
    if (static_cast<int>(out.size()) >= count) break;
    const PoseHypothesis& h = input.hypotheses[r.hypothesis];
    const Model& model = input.library[h.model];
    const Eigen::Vector3d mean = vertex_mean(model, h.world_from_model);
    bool known = false;
    for (std::size_t i = 0; i < out.size() && !known; ++i) {
      const PoseHypothesis& o = input.hypotheses[out[i].hypothesis];
      // The means are never farther apart than the vertices are on average.
      known = o.model == h.model && (means[i] - mean).norm() < kSameHypothesisMm &&
              pose_distance(model, o.world_from_model, h.world_from_model) < kSameHypothesisMm;
    }
    if (known) continue;
    out.push_back(r);
    means.push_back(mean);
  }
  return out;
}

Candidate make_candidate(const SceneInput& input, int index) {
  const PoseHypothesis& hypothesis = input.hypotheses[index];
  return make_candidate(input, hypothesis.model, hypothesis.world_from_model, {5, 2.5, 1});
}

Candidate make_candidate(const SceneInput& input, int model_index,
                         const Transform& world_from_model, const std::vector<double>& reaches_mm) {
  const Model& model = input.library[model_index];
  RefinementOptions options;
  options.reaches_mm = reaches_mm;
  options.exact_rounds = 2;
  Candidate out;
  out.model = model_index;
  out.pose = refine(input.views, {{&model, world_from_model}}, 0, options);
  VerificationOptions verification;
  verification.tests = std::max<double>(1, static_cast<double>(input.hypotheses.size()));
  const std::vector<PlacedModel> alone = {{&model, out.pose.world_from_model}};
  out.alone = verify(input.views, input.maps, alone, 0, collect_evidence(input.views, alone, 0),
                     verification);
  out.verdict = out.alone;
  return out;
}

}  // namespace trihedron
