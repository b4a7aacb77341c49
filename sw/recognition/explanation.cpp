// SPDX-License-Identifier: Apache-2.0
#include "recognition/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "recognition/solid_overlap.hpp"

namespace trihedron {
namespace {

/// Solids of verified poses penetrate each other by less, mm: the poses' errors.
constexpr double kPenetrationMm = 2.0;
/// A candidate may stand in for an occluder once so much of it is found, before it is accepted.
constexpr double kTentativeShare = 0.5;
/// Two answers are equally good when their log evidence differs by less than this share of it:
/// contrast and shadows spread the evidence of a true object by about so much.
constexpr double kAmbiguous = 0.02;
/// Poses that differ by less than this share of the diameter are one answer.
constexpr double kSameAnswer = 0.05;

class Scene {
 public:
  Scene(const std::vector<FieldView>& views, const std::vector<ChanceModel>& chance,
        const std::vector<Model>& library, std::vector<Candidate> candidates,
        const ExplanationOptions& options)
      : views_(views),
        chance_(chance),
        library_(library),
        candidates_(std::move(candidates)),
        dead_(candidates_.size(), false) {
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (options.table) check_table(static_cast<int>(i));
    }
  }

  Explanation explain() {
    fill();
    while (remove_worst()) fill();
    settle_rivals();
    return report();
  }

 private:
  PlacedModel placed(int i) const {
    return {&library_[candidates_[i].model], candidates_[i].pose.world_from_model};
  }

  const InnerPoints& inner(int model) {
    const auto known = inner_.find(model);
    if (known != inner_.end()) return known->second;
    return inner_[model] = inner_points(library_[model], kPenetrationMm);
  }

  bool in_conflict(int a, int b) {
    return overlap(placed(a), inner(candidates_[a].model), placed(b), inner(candidates_[b].model));
  }

  void reject(int i, const std::string& reason) {
    dead_[i] = true;
    candidates_[i].verdict.accepted = false;
    candidates_[i].verdict.reason = reason;
  }

  void check_table(int i) {
    double lowest = 1e300;
    for (const Eigen::Vector3d& v : library_[candidates_[i].model].mesh.vertices) {
      lowest = std::min(lowest, (candidates_[i].pose.world_from_model * v).z());
    }
    const double sigma = std::sqrt(candidates_[i].pose.covariance(5, 5));
    if (lowest > -(kPenetrationMm + 3 * sigma)) return;
    char text[80];
    std::snprintf(text, sizeof text, "below the table: reaches z = %.1f mm", lowest);
    reject(i, text);
  }

  /// Adds candidates that are in nobody's place, most evidence first.
  void fill() {
    for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
      const Verdict& alone = candidates_[i].verdict;
      if (dead_[i] || std::count(active_.begin(), active_.end(), i)) continue;
      if (alone.log10_false_alarms > -3 || alone.found_share < kTentativeShare) continue;
      const bool free = std::none_of(active_.begin(), active_.end(),
                                     [&](int other) { return in_conflict(i, other); });
      if (free) active_.push_back(i);
    }
  }

  /// The objects with candidate i last.
  std::vector<PlacedModel> context_of(int i, int without = -1) const {
    std::vector<PlacedModel> out;
    for (int other : active_) {
      if (other != i && other != without) out.push_back(placed(other));
    }
    out.push_back(placed(i));
    return out;
  }

  /// Refines and judges candidate i with the other active ones in front of it.
  void judge(int i, int without = -1) {
    Candidate& candidate = candidates_[i];
    auto context = context_of(i, without);
    const int last = static_cast<int>(context.size()) - 1;
    RefinementOptions near;
    near.reaches_mm = {1};
    near.exact_rounds = 2;
    if (context.size() > 1) {
      const RefinedPose refined = refine(views_, context, last, near);
      if (refined.converged) {
        candidate.pose = refined;
        context[last] = placed(i);
      }
    }
    candidate.verdict =
        verify(views_, chance_, context, last, collect_evidence(views_, context, last));
  }

  /// Judges all active objects together; removes the worst of those that fail. False when
  /// none fails.
  bool remove_worst() {
    for (int i : active_) judge(i);
    int worst = -1;
    for (int i : active_) {
      const Verdict& verdict = candidates_[i].verdict;
      if (verdict.accepted) continue;
      if (worst < 0 || verdict.found_share < candidates_[worst].verdict.found_share) worst = i;
    }
    if (worst < 0) return false;
    dead_[worst] = true;
    active_.erase(std::find(active_.begin(), active_.end(), worst));
    return true;
  }

  bool same_answer(int a, int b) const {
    const Model& model = library_[candidates_[a].model];
    return candidates_[a].model == candidates_[b].model &&
           pose_distance(model, candidates_[a].pose.world_from_model,
                         candidates_[b].pose.world_from_model) < kSameAnswer * model.diameter;
  }

  /// Finds each object's best rival for its place; where the two are equally good, neither is
  /// reported.
  void settle_rivals() {
    std::vector<int> ambiguous;
    for (int winner : active_) {
      for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
        if (dead_[i] || std::count(active_.begin(), active_.end(), i)) continue;
        if (!in_conflict(i, winner) || same_answer(i, winner)) continue;
        judge(i, winner);
        const double mine = candidates_[winner].verdict.log_against_chance;
        const double theirs = candidates_[i].verdict.log_against_chance;
        if (!runner_up_.count(winner) ||
            theirs > candidates_[runner_up_[winner]].verdict.log_against_chance) {
          runner_up_[winner] = i;
        }
        if (candidates_[i].verdict.accepted && theirs > mine * (1 - kAmbiguous)) {
          ambiguous.push_back(winner);
          reject(i, "ambiguous: another model or pose explains as much");
        } else if (candidates_[i].verdict.accepted) {
          reject(i, "a better answer stands in its place");
        }
      }
    }
    for (int i : ambiguous) {
      if (dead_[i]) continue;
      reject(i, "ambiguous: another model or pose explains as much");
      active_.erase(std::find(active_.begin(), active_.end(), i));
    }
  }

  RecognizedObject object(int i) const {
    const Candidate& candidate = candidates_[i];
    RecognizedObject out;
    out.model_id = library_[candidate.model].id;
    out.world_from_model = candidate.pose.world_from_model;
    out.covariance = candidate.pose.covariance;
    out.score = candidate.verdict.found_share;
    out.reprojection_rms_px = candidate.pose.rms_px;
    const auto rival = runner_up_.find(i);
    if (rival != runner_up_.end()) {
      out.runner_up_model_id = library_[candidates_[rival->second].model].id;
      out.runner_up_score = candidates_[rival->second].verdict.found_share;
    }
    add_surfaces(i, out);
    return out;
  }

  void add_surfaces(int i, RecognizedObject& out) const {
    constexpr int kLeastCells = 8;  // 32 px^2: less is not seen
    const auto context = context_of(i);
    for (int v = 0; v < static_cast<int>(views_.size()); ++v) {
      const auto seen =
          surface_visibility(*views_[v].camera, context, static_cast<int>(context.size()) - 1);
      for (int s = 0; s < static_cast<int>(seen.size()); ++s) {
        if (seen[s].visible_cells >= kLeastCells) out.surfaces.push_back({v, -1, s});
      }
    }
  }

  Explanation report() {
    Explanation out;
    for (int i : active_) out.objects.push_back(object(i));
    std::stable_sort(
        out.objects.begin(), out.objects.end(),
        [](const RecognizedObject& a, const RecognizedObject& b) { return a.score > b.score; });
    for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
      if (std::count(active_.begin(), active_.end(), i)) continue;
      const Candidate& candidate = candidates_[i];
      std::string reason = candidate.verdict.reason;
      if (reason.empty()) reason = "a better answer stands in its place";
      out.rejections.push_back({library_[candidate.model].id, candidate.pose.world_from_model,
                                candidate.verdict.found_share, reason});
    }
    return out;
  }

  const std::vector<FieldView>& views_;
  const std::vector<ChanceModel>& chance_;
  const std::vector<Model>& library_;
  std::vector<Candidate> candidates_;
  std::vector<bool> dead_;
  std::vector<int> active_;
  std::map<int, int> runner_up_;
  std::map<int, InnerPoints> inner_;
};

}  // namespace

Explanation explain(const std::vector<View>& views, const std::vector<Model>& library,
                    const std::vector<PoseHypothesis>& hypotheses,
                    const ExplanationOptions& options) {
  std::vector<ContourField> fields;
  std::vector<ChanceModel> chance;
  std::vector<FieldView> field_views;
  for (const View& view : views) fields.emplace_back(view.features);
  for (std::size_t v = 0; v < views.size(); ++v) {
    chance.push_back(chance_model(fields[v]));
    field_views.push_back({&views[v].camera, &fields[v]});
  }
  auto candidates = find_candidates(field_views, chance, library, hypotheses, options.candidates);
  return Scene(field_views, chance, library, std::move(candidates), options).explain();
}

}  // namespace trihedron
