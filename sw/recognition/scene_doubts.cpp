// SPDX-License-Identifier: Apache-2.0
// Part of the search: what speaks against a claim that no other answer of the library equals.
#include <algorithm>
#include <utility>

#include "recognition/scene_search.hpp"

namespace trihedron {
namespace {

/// Two answers are equally good when their log evidence differs by less than one independent answer
/// of a contour is worth (log 0.95 / 0.1 + log 0.9 / 0.05): noise or a shadow can give or take one;
/// or by less than this share of it, as poses alone spread the evidence of large objects.
constexpr double kAmbiguous = 5, kAmbiguousShare = 0.02;
/// What is refused by its log odds must lead by so much, the more the less it shows itself: its
/// evidence and twice its lead come to the latter at least. Of 1000 wrong poses that were held
/// against all that is alike two came to more than 80 (83 and 86), of 12 right ones 11 to 101.
constexpr double kDoubtfulLead = 10, kDoubtfulSum = 100;
/// Those of shapes stretched about their middle, mm: half of a tenth of 100 mm.
const std::vector<double> kStretchedReachesMm = {5, 2.5, 1};
/// Where more of the visible edges is found than this, no shape a tenth longer or shorter came so
/// far (0.88): such claims are not held against them.
constexpr double kSureShare = 0.9;
/// Nor were those with nearly all the log odds that there can be.
constexpr double kSureLogOdds = 9;

bool sure(const Verdict& verdict) {
  return verdict.accepted && (verdict.found_share > kSureShare || verdict.log_odds > kSureLogOdds);
}

}  // namespace

const std::vector<double> SceneSearch::kLookalikeReachesMm = {2.5, 1};

/// By how much log evidence an object must lead whatever else could be there.
double SceneSearch::lead(int winner) const {
  const Verdict& verdict = candidates_[winner].verdict;
  const double own = verdict.log_against_chance;
  if (verdict.accepted) return std::max(kAmbiguous, kAmbiguousShare * own);
  return std::max(kDoubtfulLead, (kDoubtfulSum - own) / 2);
}

/// The pose at which another shape in the winner's place gives more than `enough` log evidence:
/// `pose`, or the one refined from there; or none.
std::optional<Transform> SceneSearch::explains_more(int winner, const Model& shape,
                                                    const Transform& pose,
                                                    const std::vector<double>& reaches_mm,
                                                    double enough) const {
  int position = 0;
  std::vector<PlacedModel> context = context_of(winner, position);
  context[position] = {&shape, pose};
  const auto evidence = [&] {
    return log_against_chance(input_.maps, collect_evidence(input_.views, context, position));
  };
  if (evidence() > enough) return pose;
  RefinementOptions near;
  near.reaches_mm = reaches_mm;
  near.exact_rounds = 1;
  const RefinedPose refined = refine(input_.views, context, position, near);
  if (!refined.converged) return std::nullopt;
  context[position].world_from_model = refined.world_from_model;
  if (evidence() > enough) return refined.world_from_model;
  return std::nullopt;
}

/// Whether the mirror image in the winner's place would explain the scene as well: then nothing
/// that was seen tells which of the two it is.
SceneSearch::Doubt SceneSearch::mirrored_as_good(int winner) const {
  const Lookalikes& alike = input_.facts.lookalikes(candidates_[winner].model);
  if (!alike.mirrored) return {};
  const PlacedModel place = placed(winner);
  const double own = at_a_glance(place);
  const double enough = candidates_[winner].verdict.log_against_chance - lead(winner);
  for (const Transform& motion : alike.mirrored_onto) {
    const Transform pose = place.world_from_model * motion;
    if (at_a_glance({&*alike.mirrored, pose}) < kRivalShare * own) continue;
    const auto found = explains_more(winner, *alike.mirrored, pose, kLookalikeReachesMm, enough);
    if (!found) continue;
    return {"similar shape: the model's mirror image explains as much", {&*alike.mirrored, *found}};
  }
  return {};
}

/// Whether a plain block in the winner's place would explain the scene better.
SceneSearch::Doubt SceneSearch::block_is_better(int winner) const {
  const std::optional<Model>& block = input_.facts.lookalikes(candidates_[winner].model).block;
  const PlacedModel place = placed(winner);
  if (!block || at_a_glance({&*block, place.world_from_model}) < kRivalShare * at_a_glance(place)) {
    return {};
  }
  const Verdict& verdict = candidates_[winner].verdict;
  const double enough = verdict.log_against_chance - (verdict.accepted ? 0 : lead(winner));
  const auto found =
      explains_more(winner, *block, place.world_from_model, kStretchedReachesMm, enough);
  if (!found) return {};
  return {"similar shape: a plain block explains more", {&*block, *found}};
}

/// The model longer or shorter by a tenth, at the place that agrees best at a glance.
SimilarShapes SceneSearch::stretched(int winner) const {
  SimilarShapes all = stretched_shapes(placed(winner));
  SimilarShapes out{{}, all.log_choices};
  const auto score = [&](const SimilarShape& shape) {
    return at_a_glance({&shape.model, shape.world_from_model});
  };
  for (auto place = all.shapes.begin(); place != all.shapes.end(); place += kStretchPlaces) {
    auto best = place;
    double highest = score(*best);
    for (auto other = place + 1; other != place + kStretchPlaces; ++other) {
      const double here = score(*other);
      if (here <= highest) continue;
      highest = here;
      best = other;
    }
    out.shapes.push_back(std::move(*best));
  }
  return out;
}

/// Whether a similar shape would explain the scene better, and what differs.
SceneSearch::Doubt SceneSearch::similar_is_better(int winner) {
  int position = 0;
  const std::vector<PlacedModel> context = context_of(winner, position);
  const ObjectEvidence evidence = collect_evidence(input_.views, context, position);
  const Verdict& verdict = candidates_[winner].verdict;
  const auto better = [&](const SimilarShapes& similar, const std::vector<double>& reaches_mm) {
    const double enough =
        verdict.log_against_chance + (verdict.accepted ? similar.log_choices : -lead(winner));
    for (const SimilarShape& shape : similar.shapes) {
      const auto pose =
          explains_more(winner, shape.model, shape.world_from_model, reaches_mm, enough);
      if (!pose) continue;
      shapes_.push_back(shape.model);
      return Doubt{"similar shape: " + shape.what + " explains more", {&shapes_.back(), *pose}};
    }
    return Doubt{};
  };
  const Doubt doubt = better(similar_shapes(input_.views, input_.maps, context[position], evidence),
                             kLookalikeReachesMm);
  if (!doubt.reason.empty() || sure(verdict)) return doubt;
  return better(stretched(winner), kStretchedReachesMm);
}

/// What speaks against an object that no accepted rival equals.
SceneSearch::Doubt SceneSearch::doubt_about(int winner) {
  const int next = runner_up(winner);
  const double mine = candidates_[winner].verdict.log_against_chance;
  if (next >= 0 && candidates_[next].verdict.log_against_chance > mine - lead(winner)) {
    return {"ambiguous: an answer that is refused explains as much", placed(winner)};
  }
  Doubt doubt = mirrored_as_good(winner);
  if (doubt.reason.empty()) doubt = block_is_better(winner);
  return doubt.reason.empty() ? similar_is_better(winner) : doubt;
}

}  // namespace trihedron
