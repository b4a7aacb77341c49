// SPDX-License-Identifier: Apache-2.0
// The last part of the search: objects are held against what else might stand in their places.
#include <algorithm>

#include "recognition/scene_search.hpp"
#include "recognition/similar_shapes.hpp"

namespace trihedron {
namespace {

/// Two answers are equally good when their log evidence differs by less than this share of it:
/// contrast and shadows spread the evidence of a true object by about so much.
constexpr double kAmbiguous = 0.02;
/// Rivals for an object's place are looked at when their quick score reaches this share of its
/// own, and so many of them.
constexpr double kRivalShare = 0.7;
constexpr int kRivals = 3;
/// The same of the log evidence when nothing is thought to hide the rival.
constexpr double kRivalShareAlone = 0.4;
/// Poses that differ by less than this share of the diameter are one answer.
constexpr double kSameAnswer = 0.05;
/// Poses of lookalikes are known to kCoincide of the diameter: how far contours are looked for, mm.
const std::vector<double> kLookalikeReachesMm = {2.5, 1};
/// Those of shapes stretched about their middle, mm: half of a tenth of 100 mm.
const std::vector<double> kStretchedReachesMm = {5, 2.5, 1};
/// No shape a tenth longer or shorter has come so far: such claims are not held against them.
constexpr double kSureLogOdds = 6;

}  // namespace

int SceneSearch::runner_up(int active) const {
  const auto found = runner_up_.find(active);
  return found == runner_up_.end() ? -1 : found->second;
}

/// How well a pose agrees with all contours, no hidden lines removed.
double SceneSearch::at_a_glance(const Model& model, const Transform& pose) const {
  return all_contours_.score(glance_points(input_.views, model, pose));
}

/// Refines the best hypotheses that claim an object's place with another answer.
void SceneSearch::find_rivals(int winner) {
  const double own = at_a_glance(*placed(winner).model, placed(winner).world_from_model);
  int found = 0;
  for (const RankedHypothesis& ranked : first_ranking_) {
    if (found >= kRivals || ranked.score < kRivalShare * own) break;
    const PoseHypothesis& h = input_.hypotheses[ranked.hypothesis];
    const PlacedModel place{&input_.library[h.model], h.world_from_model};
    if (tried_[ranked.hypothesis] ||
        !overlap(place, inner(h.model), placed(winner), inner(candidates_[winner].model))) {
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
  const double own = at_a_glance(*place.model, place.world_from_model);
  const int model = candidates_[winner].model;
  for (const Transform& turn : input_.facts.lookalikes(model).turned) {
    const Transform pose = place.world_from_model * turn;
    if (at_a_glance(*place.model, pose) < kRivalShare * own) continue;
    add(make_candidate(input_, model, pose, kLookalikeReachesMm));
  }
}

/// Whether another shape in the winner's place, at `pose` or refined from there, gives more than
/// `enough` log evidence.
bool SceneSearch::explains_more(int winner, const Model& shape, const Transform& pose,
                                const std::vector<double>& reaches_mm, double enough) const {
  int position = 0;
  std::vector<PlacedModel> context = context_of(winner, position);
  context[position] = {&shape, pose};
  const auto evidence = [&] {
    return verify(input_.views, input_.maps, context, position,
                  collect_evidence(input_.views, context, position))
        .log_against_chance;
  };
  if (evidence() > enough) return true;
  RefinementOptions near;
  near.reaches_mm = reaches_mm;
  near.exact_rounds = 2;
  const RefinedPose refined = refine(input_.views, context, position, near);
  if (!refined.converged) return false;
  context[position].world_from_model = refined.world_from_model;
  return evidence() > enough;
}

/// Whether the mirror image in the winner's place would explain the scene as well: then nothing
/// that was seen tells which of the two it is.
bool SceneSearch::mirrored_as_good(int winner) const {
  const Lookalikes& alike = input_.facts.lookalikes(candidates_[winner].model);
  if (!alike.mirrored) return false;
  const PlacedModel place = placed(winner);
  const double own = at_a_glance(*place.model, place.world_from_model);
  const double enough = candidates_[winner].verdict.log_against_chance * (1 - kAmbiguous);
  return std::any_of(
      alike.mirrored_onto.begin(), alike.mirrored_onto.end(), [&](const Transform& motion) {
        const Transform pose = place.world_from_model * motion;
        return at_a_glance(*alike.mirrored, pose) >= kRivalShare * own &&
               explains_more(winner, *alike.mirrored, pose, kLookalikeReachesMm, enough);
      });
}

/// What differs in a similar shape that would explain the scene better, "": none would.
std::string SceneSearch::similar_is_better(int winner) const {
  int position = 0;
  const std::vector<PlacedModel> context = context_of(winner, position);
  const ObjectEvidence evidence = collect_evidence(input_.views, context, position);
  const SimilarShapes similar =
      similar_shapes(input_.views, input_.maps, context[position], evidence);
  const double enough = candidates_[winner].verdict.log_against_chance + similar.log_choices;
  const auto better = [&](const SimilarShape& shape, const std::vector<double>& reaches_mm) {
    return explains_more(winner, shape.model, shape.world_from_model, reaches_mm, enough);
  };
  for (const SimilarShape& shape : similar.placed) {
    if (better(shape, kLookalikeReachesMm)) return shape.what;
  }
  if (candidates_[winner].verdict.log_odds > kSureLogOdds) return "";
  for (const SimilarShape& shape : similar.near) {
    if (better(shape, kStretchedReachesMm)) return shape.what;
  }
  return "";
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

/// What speaks against an object that no accepted rival equals, "": nothing.
std::string SceneSearch::doubt_about(int winner) {
  const int next = runner_up(winner);
  const double mine = candidates_[winner].verdict.log_against_chance;
  if (next >= 0 && candidates_[next].verdict.log_against_chance > mine * (1 - kAmbiguous)) {
    return "ambiguous: an answer that is refused explains as much";
  }
  if (mirrored_as_good(winner)) return "similar shape: the model's mirror image explains as much";
  const std::string similar = similar_is_better(winner);
  return similar.empty() ? "" : "similar shape: " + similar + " explains more";
}

/// Holds an object against its rivals: one that explains clearly more takes its place, one that
/// explains as much leaves it empty.
void SceneSearch::settle_rivals(int winner) {
  const char* const kAsGood = "ambiguous: another model or pose explains as much";
  const char* const kBetter = "a better answer stands in its place";
  for (int round = 0; round < kRivals; ++round) {
    add_turned(winner);
    const int rival = best_rival(winner);
    const double mine = candidates_[winner].verdict.log_against_chance;
    const double theirs = rival < 0 ? 0 : candidates_[rival].verdict.log_against_chance;
    const auto place = std::find(active_.begin(), active_.end(), winner);
    if (rival < 0 || theirs < mine * (1 - kAmbiguous)) {
      if (rival >= 0) reject(rival, kBetter);
      const std::string doubt = doubt_about(winner);
      if (doubt.empty()) return;
      reject(winner, doubt);
      active_.erase(place);
      return;
    }
    reject(winner, theirs * (1 - kAmbiguous) > mine ? kBetter : kAsGood);
    if (theirs * (1 - kAmbiguous) <= mine) {
      reject(rival, kAsGood);
      active_.erase(place);
      return;
    }
    *place = winner = rival;
  }
}

void SceneSearch::settle_rivals() {
  const std::vector<int> winners = active_;
  for (int winner : winners) find_rivals(winner);
  for (int winner : winners) settle_rivals(winner);
}

}  // namespace trihedron
