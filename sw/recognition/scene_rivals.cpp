// SPDX-License-Identifier: Apache-2.0
// The last part of the search: objects are held against what else might stand in their places.
#include <algorithm>

#include "recognition/scene_search.hpp"
#include "recognition/similar_shapes.hpp"

namespace trihedron {
namespace {

/// Two answers are equally good when their log evidence differs by less than one independent answer
/// of a contour is worth (log 0.95 / 0.1 + log 0.9 / 0.05): noise or a shadow can give or take one;
/// or by less than this share of it, as poses alone spread the evidence of large objects.
constexpr double kAmbiguous = 5, kAmbiguousShare = 0.02;
/// Rivals for an object's place are looked at when their quick score reaches this share of its
/// own, and so many of them.
constexpr double kRivalShare = 0.7;
constexpr int kRivals = 3;
/// Rounds until all objects stand in one scene: a chain of so many that hide one another.
constexpr int kSettleRounds = 5;
/// The same of the log evidence when nothing is thought to hide the rival.
constexpr double kRivalShareAlone = 0.4;
/// Poses that differ by less than this share of the diameter are one answer.
constexpr double kSameAnswer = 0.05;
/// Poses of lookalikes are known to kCoincide of the diameter: how far contours are looked for, mm.
const std::vector<double> kLookalikeReachesMm = {2.5, 1};
/// Those of shapes stretched about their middle, mm: half of a tenth of 100 mm.
const std::vector<double> kStretchedReachesMm = {5, 2.5, 1};
/// Where more of the visible edges is found than this, no shape a tenth longer or shorter came so
/// far (0.88): such claims are not held against them.
constexpr double kSureShare = 0.9;
/// Nor were those with nearly all the log odds that there can be.
constexpr double kSureLogOdds = 9;

bool sure(const Verdict& verdict) {
  return verdict.found_share > kSureShare || verdict.log_odds > kSureLogOdds;
}

double ambiguity(double log_evidence) {
  return std::max(kAmbiguous, kAmbiguousShare * log_evidence);
}

}  // namespace

int SceneSearch::runner_up(int object) const {
  const auto found = runner_up_.find(object);
  return found == runner_up_.end() ? -1 : found->second;
}

/// How well what can be seen of an object agrees with all contours, nothing in front of it.
double SceneSearch::at_a_glance(const PlacedModel& object) const {
  return all_contours_.score(visible_glance_points(input_.views, object));
}

/// Refines the best hypotheses that claim an object's place with another answer.
void SceneSearch::find_rivals(int winner) {
  const PlacedModel best = placed(winner);
  const double own =
      all_contours_.score(glance_points(input_.views, *best.model, best.world_from_model));
  int found = 0;
  for (const RankedHypothesis& ranked : first_ranking_) {
    if (found >= kRivals || ranked.score < kRivalShare * own) break;
    const PoseHypothesis& h = input_.hypotheses[ranked.hypothesis];
    const PlacedModel place{&input_.library[h.model], h.world_from_model};
    if (tried_[ranked.hypothesis] ||
        !overlap(place, inner(h.model), best, inner(candidates_[winner].model))) {
      continue;
    }
    add(ranked.hypothesis);
    ++found;
  }
}

bool SceneSearch::is_rival(int i, int winner) {
  if (std::count(active_.begin(), active_.end(), i) || !in_conflict(i, winner)) return false;
  const bool same =
      candidates_[i].model == candidates_[winner].model &&
      pose_distance(*placed(i).model, placed(i).world_from_model, placed(winner).world_from_model) <
          kSameAnswer * placed(i).model->diameter;
  if (same) return false;
  return std::none_of(active_.begin(), active_.end(),
                      [&](int other) { return other != winner && in_conflict(i, other); });
}

/// Adds the model's other poses that share most edges with the winner's, where they agree nearly
/// as well at a glance.
void SceneSearch::add_turned(int winner) {
  const PlacedModel place = placed(winner);
  const double own = at_a_glance(place);
  const int model = candidates_[winner].model;
  for (const Transform& turn : input_.facts.lookalikes(model).turned) {
    const Transform pose = place.world_from_model * turn;
    if (at_a_glance({place.model, pose}) < kRivalShare * own) continue;
    add(make_candidate(input_, model, pose, kLookalikeReachesMm));
  }
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
  const double mine = candidates_[winner].verdict.log_against_chance;
  const double enough = mine - ambiguity(mine);
  for (const Transform& motion : alike.mirrored_onto) {
    const Transform pose = place.world_from_model * motion;
    if (at_a_glance({&*alike.mirrored, pose}) < kRivalShare * own) continue;
    const auto found = explains_more(winner, *alike.mirrored, pose, kLookalikeReachesMm, enough);
    if (!found) continue;
    return {"similar shape: the model's mirror image explains as much", {&*alike.mirrored, *found}};
  }
  return {};
}

/// Whether a similar shape would explain the scene better, and what differs.
SceneSearch::Doubt SceneSearch::similar_is_better(int winner) {
  int position = 0;
  const std::vector<PlacedModel> context = context_of(winner, position);
  const ObjectEvidence evidence = collect_evidence(input_.views, context, position);
  const Verdict& verdict = candidates_[winner].verdict;
  const auto better = [&](const SimilarShapes& similar, const std::vector<double>& reaches_mm) {
    const double enough = verdict.log_against_chance + similar.log_choices;
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
  return better(stretched_shapes(context[position]), kStretchedReachesMm);
}

/// Judges every rival for the winner's place; the best accepted one, -1: none.
int SceneSearch::best_rival(int winner) {
  int best = -1;
  const double mine = candidates_[winner].verdict.log_against_chance;
  for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
    // What is judged alone may look poor because others hide it.
    const double theirs_alone = candidates_[i].alone.log_against_chance;
    if (theirs_alone < kRivalShareAlone * mine || !is_rival(i, winner)) continue;
    const auto place = std::find(active_.begin(), active_.end(), winner);
    *place = i;  // the same scene with the rival in the winner's place
    judge(i);
    *place = winner;
    const auto evidence = [&](int c) { return candidates_[c].verdict.log_against_chance; };
    const int next = runner_up(winner);
    if (next < 0 || evidence(i) > evidence(next)) runner_up_[winner] = i;
    if (!candidates_[i].verdict.accepted) continue;
    if (best < 0 || evidence(i) > evidence(best)) best = i;
  }
  return best;
}

/// What speaks against an object that no accepted rival equals.
SceneSearch::Doubt SceneSearch::doubt_about(int winner) {
  const int next = runner_up(winner);
  const double mine = candidates_[winner].verdict.log_against_chance;
  if (next >= 0 && candidates_[next].verdict.log_against_chance > mine - ambiguity(mine)) {
    return {"ambiguous: an answer that is refused explains as much", placed(winner)};
  }
  Doubt mirrored = mirrored_as_good(winner);
  return mirrored.reason.empty() ? similar_is_better(winner) : mirrored;
}

/// Takes a claim back; something stands there all the same.
void SceneSearch::withdraw(int i, const Doubt& doubt) {
  reject(i, doubt.reason);
  instead_[i] = doubt.instead;
}

/// Holds an object against its rivals: one that explains clearly more takes its place, one that
/// explains as much takes the claim back.
void SceneSearch::settle_rivals(int winner) {
  const char* const kAsGood = "ambiguous: another model or pose explains as much";
  const char* const kBetter = "a better answer stands in its place";
  for (int round = 0; round < kRivals; ++round) {
    add_turned(winner);
    const int rival = best_rival(winner);
    const double mine = candidates_[winner].verdict.log_against_chance;
    const double theirs = rival < 0 ? 0 : candidates_[rival].verdict.log_against_chance;
    if (rival < 0 || theirs < mine - ambiguity(mine)) {
      if (rival >= 0) reject(rival, kBetter);
      const Doubt doubt = doubt_about(winner);
      if (!doubt.reason.empty()) withdraw(winner, doubt);
      return;
    }
    if (theirs - ambiguity(theirs) <= mine) {
      reject(rival, kAsGood);
      withdraw(winner, {kAsGood, placed(winner)});
      return;
    }
    reject(winner, kBetter);
    *std::find(active_.begin(), active_.end(), winner) = rival;
    winner = rival;
  }
}

/// Holds all objects against their rivals. Whatever takes the place of one changes what its
/// neighbours were judged beside, so they are asked again until all stand in one scene.
void SceneSearch::settle_rivals() {
  const std::vector<int> winners = active_;
  for (int winner : winners) find_rivals(winner);
  std::map<int, std::vector<int>> settled_in;
  const auto unsettled = [&](int i) {
    const auto last = settled_in.find(i);
    return last == settled_in.end() || last->second != standing_with(i);
  };
  for (int round = 0; round < kSettleRounds; ++round) {
    const std::vector<int> claims = objects();
    if (std::none_of(claims.begin(), claims.end(), unsettled)) return;
    for (int i : claims) {
      if (!unsettled(i)) continue;
      judge(i);
      settled_in[i] = standing_with(i);
      if (candidates_[i].verdict.accepted) {
        settle_rivals(i);
      } else {
        dead_[i] = 1;
        active_.erase(std::find(active_.begin(), active_.end(), i));
      }
    }
  }
}

}  // namespace trihedron
