// SPDX-License-Identifier: Apache-2.0
#include "recognition/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/projected_model.hpp"

namespace trihedron {
namespace {

/// Hypotheses nearer than this refine to the same pose, mm.
constexpr double kSameHypothesisMm = 3.0;
/// Refined poses nearer than this are the same, mm.
constexpr double kSamePoseMm = 1.0;

double vertex_distance(const Model& model, const Transform& a, const Transform& b) {
  double sum = 0;
  for (const Eigen::Vector3d& v : model.mesh.vertices) sum += (a * v - b * v).norm();
  return sum / static_cast<double>(model.mesh.vertices.size());
}

struct Ranked {
  double score;
  int hypothesis;
};

/// The best-scored hypotheses, none near a better one of the same model.
std::vector<Ranked> distinct(const std::vector<Model>& library,
                             const std::vector<PoseHypothesis>& hypotheses,
                             std::vector<Ranked> ranked, int count) {
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Ranked& a, const Ranked& b) { return a.score > b.score; });
  std::vector<Ranked> out;
  for (const Ranked& r : ranked) {
    if (static_cast<int>(out.size()) >= count) break;
    const PoseHypothesis& h = hypotheses[r.hypothesis];
    const bool known = std::any_of(out.begin(), out.end(), [&](const Ranked& other) {
      const PoseHypothesis& o = hypotheses[other.hypothesis];
      return o.model == h.model && pose_distance(library[h.model], o.world_from_model,
                                                 h.world_from_model) < kSameHypothesisMm;
    });
    if (!known) out.push_back(r);
  }
  return out;
}

}  // namespace

double pose_distance(const Model& model, const Transform& a, const Transform& b) {
  double best = vertex_distance(model, a, b);
  for (const Transform& symmetry : model.symmetries) {
    best = std::min(best, vertex_distance(model, a, b * symmetry));
  }
  return best;
}

double quick_score(const std::vector<FieldView>& views, const Model& model,
                   const Transform& world_from_model) {
  constexpr double kStepPx = 16;  // independent answers
  constexpr int kLevel = 0;       // contours within 4 to 8 px
  double score = 0;
  for (const FieldView& view : views) {
    const ProjectedModel projected = project_model(*view.camera, {&model, world_from_model});
    std::vector<Eigen::Vector2d> pixels;
    for (const Eigen::Vector3d& x : projected.x_in_camera) {
      pixels.push_back(view.camera->project_camera(x));
    }
    for (const ModelEdge& edge : model.edges) {
      const bool left = projected.front[edge.left], right = projected.front[edge.right];
      if ((!left && !right) || (!edge.convex && left != right)) continue;
      const Eigen::Vector2d along = pixels[edge.v1] - pixels[edge.v0];
      const int count = static_cast<int>(along.norm() / kStepPx);
      if (count == 0) continue;
      const int bin = ContourField::bin_of(-along.y(), along.x());
      const double chance = std::clamp(view.field->density(kLevel, bin), 0.01, 0.9);
      const double hit = std::log(0.9 / chance), miss = std::log(0.1 / (1 - chance));
      for (int i = 0; i < count; ++i) {
        const Eigen::Vector2d x = pixels[edge.v0] + (i + 0.5) / count * along;
        if (!view.field->inside(x, 0)) continue;
        score += view.field->near(kLevel, x, bin) ? hit : miss;
      }
    }
  }
  return score;
}

std::vector<Candidate> find_candidates(const std::vector<FieldView>& views,
                                       const std::vector<ChanceModel>& chance,
                                       const std::vector<Model>& library,
                                       const std::vector<PoseHypothesis>& hypotheses,
                                       const CandidateOptions& options) {
  std::vector<Ranked> ranked;
  const int quick = std::min(options.quick, static_cast<int>(hypotheses.size()));
  for (int i = 0; i < quick; ++i) {
    const PoseHypothesis& h = hypotheses[i];
    ranked.push_back({quick_score(views, library[h.model], h.world_from_model), i});
  }
  std::vector<Candidate> out;
  VerificationOptions verification;
  verification.tests = std::max<double>(1, static_cast<double>(hypotheses.size()));
  for (const Ranked& r : distinct(library, hypotheses, ranked, options.refined)) {
    const PoseHypothesis& h = hypotheses[r.hypothesis];
    const Model& model = library[h.model];
    Candidate candidate;
    candidate.model = h.model;
    candidate.pose = refine(views, {{&model, h.world_from_model}}, 0);
    if (!candidate.pose.converged) continue;
    const Transform& pose = candidate.pose.world_from_model;
    const bool known = std::any_of(out.begin(), out.end(), [&](const Candidate& other) {
      return other.model == h.model &&
             pose_distance(model, other.pose.world_from_model, pose) < kSamePoseMm;
    });
    if (known) continue;
    const std::vector<PlacedModel> alone = {{&model, pose}};
    candidate.verdict =
        verify(views, chance, alone, 0, collect_evidence(views, alone, 0), verification);
    out.push_back(candidate);
  }
  std::stable_sort(out.begin(), out.end(), [](const Candidate& a, const Candidate& b) {
    return a.verdict.log_against_chance > b.verdict.log_against_chance;
  });
  return out;
}

}  // namespace trihedron
