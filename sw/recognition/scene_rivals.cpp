// SPDX-License-Identifier: Apache-2.0
// The last part of the search: objects are held against what else might stand in their places.
#include <algorithm>
#include <set>

#include "recognition/scene_search.hpp"

namespace trihedron {
namespace {

/// So many rivals for an object's place are looked at.
constexpr int kRivals = 3;
/// Rounds until all objects stand in one scene: a chain of so many that hide one another.
constexpr int kSettleRounds = 5;
/// The same of the log evidence when nothing is thought to hide the rival.
constexpr double kRivalShareAlone = 0.4;
/// Poses that differ by less than this share of the diameter are one answer.
constexpr double kSameAnswer = 0.05;
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

/// Takes a claim back. Something stands there all the same, unless that was in doubt.
void SceneSearch::withdraw(int i, const Doubt& doubt) {
  const bool stands = candidates_[i].verdict.accepted;
  reject(i, doubt.reason);
  if (stands) {
    instead_[i] = doubt.instead;
  } else {
    active_.erase(std::find(active_.begin(), active_.end(), i));
  }
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
    if (rival < 0 || theirs < mine - lead(winner)) {
      if (rival >= 0) reject(rival, kBetter);
      const Doubt doubt = doubt_about(winner);
      if (!doubt.reason.empty()) withdraw(winner, doubt);
      return;
    }
    if (theirs - lead(winner) <= mine) {
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
void SceneSearch::settle_all(std::map<int, std::vector<int>>& settled_in) {
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
      const Verdict& verdict = candidates_[i].verdict;
      if (verdict.accepted || verdict.doubtful) {
        settle_rivals(i);
      } else {
        dead_[i] = 1;
        active_.erase(std::find(active_.begin(), active_.end(), i));
      }
    }
  }
}

/// The best answer for a free place that was refused, but only just, and not asked before; -1:
/// none.
int SceneSearch::best_refused(const std::set<int>& asked) {
  constexpr double kWorthAsking = 0.5;  // of the evidence it needs: its neighbours were others
  int best = -1;
  for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
    Candidate& candidate = candidates_[i];
    const double before =
        std::max(candidate.alone.log_against_chance, candidate.verdict.log_against_chance);
    std::string reason;
    if (before < kWorthAsking * kDoubtfulEvidence || asked.count(i) ||
        std::count(active_.begin(), active_.end(), i) || below_table(candidate, reason) ||
        std::any_of(active_.begin(), active_.end(), [&](int o) { return in_conflict(i, o); })) {
      continue;
    }
    judge(i);
    const Verdict& verdict = candidate.verdict;
    if (!verdict.doubtful && !verdict.accepted) continue;
    if (best < 0 || verdict.log_against_chance > candidates_[best].verdict.log_against_chance) {
      best = i;
    }
  }
  return best;
}

/// Whether the scene is explained better with the last object than without it, and all others
/// hold. Otherwise they are as they were.
bool SceneSearch::last_improves() {
  const std::vector<Candidate> candidates = candidates_;
  const std::map<int, std::vector<int>> judged_in = judged_in_;
  double gain = candidates_[active_.back()].verdict.log_against_chance;
  bool hold = true;
  for (int i : objects()) {
    if (i == active_.back()) continue;
    gain -= candidates_[i].verdict.log_against_chance;
    judge(i);
    gain += candidates_[i].verdict.log_against_chance;
    hold = hold && candidates_[i].verdict.accepted >= candidates[i].verdict.accepted;
  }
  if (hold && gain >= kDoubtfulEvidence) return true;
  candidates_ = candidates;
  judged_in_ = judged_in;
  return false;
}

/// Adds an answer that its log odds alone refused and that leads all that is alike, which tells
/// more. False: there is none.
bool SceneSearch::reconsider(std::set<int>& asked) {
  for (int i = best_refused(asked); i >= 0; i = best_refused(asked)) {
    asked.insert(i);
    const std::size_t before = active_.size();
    active_.push_back(i);
    find_rivals(i);
    settle_rivals(i);
    if (active_.size() == before) continue;
    const int last = active_.back();
    asked.insert(last);
    const bool claimed = instead_.count(last) == 0;
    if (claimed && last_improves()) return true;
    if (claimed) reject(last, "partial: others explain what it would");
    instead_.erase(last);
    active_.pop_back();
  }
  return false;
}

void SceneSearch::settle_rivals() {
  const std::vector<int> winners = active_;
  for (int winner : winners) find_rivals(winner);
  std::map<int, std::vector<int>> settled_in;
  std::set<int> asked;
  do {
    settle_all(settled_in);
  } while (reconsider(asked));
}

}  // namespace trihedron
