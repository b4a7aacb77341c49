// SPDX-License-Identifier: Apache-2.0
#include "recognition/scene_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace trihedron {
namespace {

/// A candidate may stand in for an occluder once so much of it is found, before it is accepted.
constexpr double kTentativeShare = 0.35;
/// Expected false alarms of a candidate that may be tried at all, as log10.
constexpr double kTentativeLog10 = -3;
/// Log odds of a candidate alone above which an object that hides it may be all that it lacks: one
/// view that sees it nowhere costs as much.
constexpr double kMayBeLogOdds = -4;
/// Refined poses nearer than this are the same, mm.
constexpr double kSamePoseMm = 1.0;

}  // namespace

SceneSearch::SceneSearch(SceneInput& input, const SceneSearchOptions& options)
    : input_(input),
      options_(options),
      ranker_(input, options.table ? -(kRefinedByMm + kPenetrationMm)
                                   : -std::numeric_limits<double>::infinity()),
      all_contours_(input.maps),
      first_ranking_(ranker_.rank(all_contours_, options.ranked)),
      tried_(input.hypotheses.size(), 0) {}

void SceneSearch::run() {
  search(options_.patience);
  if (ask_for_more()) search(options_.patience_for_more);
  settle_rivals();
}

void SceneSearch::search(int patience) {
  for (int idle = 0; idle < patience;) {
    const std::vector<int> before = active_;
    if (!try_batch()) break;
    idle = active_ == before ? idle + 1 : 0;
  }
}

/// Asks for hypotheses of what the objects so far leave; false when there are none.
bool SceneSearch::ask_for_more() {
  if (!input_.more || active_.empty()) return false;
  std::vector<PlacedModel> known;
  for (int i : active_) known.push_back(placed(i));
  const std::vector<PoseHypothesis> more = input_.more(known);
  input_.hypotheses.insert(input_.hypotheses.end(), more.begin(), more.end());
  ranker_.update();
  tried_.resize(input_.hypotheses.size(), 0);
  return !more.empty();
}

PlacedModel SceneSearch::placed(int i) const {
  const auto instead = instead_.find(i);
  if (instead != instead_.end()) return instead->second;
  return {&input_.library[candidates_[i].model], candidates_[i].pose.world_from_model};
}

std::vector<int> SceneSearch::objects() const {
  std::vector<int> out;
  for (int i : active_) {
    if (!instead_.count(i)) out.push_back(i);
  }
  return out;
}

bool SceneSearch::in_conflict(int a, int b) {
  return overlap(placed(a), inner(candidates_[a].model), placed(b), inner(candidates_[b].model));
}

bool SceneSearch::known(const Candidate& candidate) const {
  const Model& model = input_.library[candidate.model];
  return std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
    return other.model == candidate.model &&
           pose_distance(model, other.pose.world_from_model, candidate.pose.world_from_model) <
               kSamePoseMm;
  });
}

void SceneSearch::reject(int i, const std::string& reason) {
  dead_[i] = 1;
  candidates_[i].verdict.accepted = false;
  candidates_[i].verdict.reason = reason;
}

bool SceneSearch::below_table(const Candidate& candidate, std::string& reason) const {
  const double z = lowest(input_.library[candidate.model], candidate.pose.world_from_model);
  const double sigma = std::sqrt(candidate.pose.covariance(5, 5));
  if (!options_.table || z > -(kPenetrationMm + 3 * sigma)) return false;
  char text[80];
  std::snprintf(text, sizeof text, "below the table: reaches z = %.1f mm", z);
  reason = text;
  return true;
}

std::vector<RankedHypothesis> SceneSearch::rank_rest() {
  if (active_.empty()) return first_ranking_;
  std::vector<PlacedModel> objects;
  for (int i : active_) objects.push_back(placed(i));
  const Remainder rest = remainder(input_.views, objects);
  return ranker_.rank(GlanceScorer(input_.maps, rest), options_.ranked);
}

bool SceneSearch::try_batch() {
  int added = 0, batch = options_.batch;
  for (const RankedHypothesis& ranked : rank_rest()) {
    if (added >= batch) break;
    if (tried_[ranked.hypothesis]) continue;
    const PoseHypothesis& h = input_.hypotheses[ranked.hypothesis];
    const PlacedModel place{&input_.library[h.model], h.world_from_model};
    const bool taken = std::any_of(active_.begin(), active_.end(), [&](int i) {
      return overlap(place, inner(h.model), placed(i), inner(candidates_[i].model));
    });
    if (taken) continue;
    const std::size_t before = candidates_.size();
    add(ranked.hypothesis);
    ++added;
    const bool accepted =
        candidates_.size() > before && !dead_.back() && candidates_.back().alone.accepted;
    if (!active_.empty() || !accepted || !explains_all(static_cast<int>(before))) continue;
    batch = std::min(batch, added + 1);  // the next best is its runner-up
  }
  if (added) settle();
  return added > 0;
}

/// Whether nothing beside a candidate is likelier than chance, once the contours that it explains
/// are left out. Other answers in its place are its rivals, which are looked for later.
bool SceneSearch::explains_all(int candidate) {
  active_.push_back(candidate);
  const std::vector<RankedHypothesis> rest = rank_rest();
  active_.pop_back();
  return std::all_of(rest.begin(), rest.end(), [&](const RankedHypothesis& ranked) {
    const PoseHypothesis& h = input_.hypotheses[ranked.hypothesis];
    const PlacedModel place{&input_.library[h.model], h.world_from_model};
    return tried_[ranked.hypothesis] ||
           overlap(place, inner(h.model), placed(candidate), inner(candidates_[candidate].model));
  });
}

void SceneSearch::add(int hypothesis) {
  tried_[hypothesis] = 1;
  const PoseHypothesis& h = input_.hypotheses[hypothesis];
  const PlacedModel place{&input_.library[h.model], h.world_from_model};
  std::vector<PlacedModel> known;
  for (int i : active_) {
    const PlacedModel other = placed(i);
    if (!overlap(place, inner(h.model), other, inner(candidates_[i].model))) known.push_back(other);
  }
  add(make_candidate(input_, hypothesis, known));
}

void SceneSearch::add(const Candidate& candidate) {
  if (!candidate.pose.converged || known(candidate)) return;
  std::string reason;
  const bool below = below_table(candidate, reason);
  candidates_.push_back(candidate);
  dead_.push_back(0);
  if (below) reject(static_cast<int>(candidates_.size()) - 1, reason);
}

/// Adds candidates that are in nobody's place, most evidence first.
void SceneSearch::fill() {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
    const Verdict& alone = candidates_[i].alone;
    if (dead_[i] || std::count(active_.begin(), active_.end(), i)) continue;
    if (alone.log10_false_alarms > kTentativeLog10 || alone.found_share < kTentativeShare) continue;
    order.push_back(i);
  }
  const auto more_evidence = [&](int a, int b) {
    return candidates_[a].alone.log_against_chance > candidates_[b].alone.log_against_chance;
  };
  std::stable_sort(order.begin(), order.end(), more_evidence);
  for (int i : order) {
    const bool free = std::none_of(active_.begin(), active_.end(),
                                   [&](int other) { return in_conflict(i, other); });
    if (free) active_.push_back(i);
  }
  std::stable_sort(active_.begin(), active_.end(), more_evidence);
}

std::vector<PlacedModel> SceneSearch::context_of(int i, int& position) const {
  std::vector<PlacedModel> out;
  position = -1;
  for (int other : active_) {
    if (other == i) position = static_cast<int>(out.size());
    out.push_back(placed(other));
  }
  if (position < 0) {
    position = static_cast<int>(out.size());
    out.push_back(placed(i));
  }
  return out;
}

/// The scene in which candidate i is judged: what stands there, i among it; below 0: something
/// that is not claimed.
std::vector<int> SceneSearch::standing_with(int i) const {
  std::vector<int> out;
  for (int other : active_) out.push_back(instead_.count(other) ? -1 - other : other);
  if (!std::count(active_.begin(), active_.end(), i)) out.push_back(i);
  return out;
}

/// Refines and judges candidate i with the active ones before it, unless nothing changed.
void SceneSearch::judge(int i) {
  const std::vector<int> neighbours = standing_with(i);
  const auto last = judged_in_.find(i);
  if (last != judged_in_.end() && last->second == neighbours) return;
  judged_in_[i] = neighbours;
  Candidate& candidate = candidates_[i];
  int position = 0;
  auto context = context_of(i, position);
  RefinementOptions near;
  near.reaches_mm = {1};
  near.exact_rounds = 2;
  const RefinedPose refined = refine(input_.views, context, position, near);
  if (refined.converged) {
    candidate.pose = refined;
    context[position] = placed(i);
  }
  VerificationOptions options;
  options.tests = std::max<double>(1, static_cast<double>(input_.hypotheses.size()));
  candidate.verdict = verify(input_.views, input_.maps, context, position,
                             collect_evidence(input_.views, context, position), options);
}

/// Judges all active objects together; removes the worst of those that fail. False when none
/// fails.
bool SceneSearch::remove_worst() {
  for (int i : active_) judge(i);
  int worst = -1;
  for (int i : active_) {
    const Verdict& verdict = candidates_[i].verdict;
    if (verdict.accepted) continue;
    if (worst < 0 || verdict.found_share < candidates_[worst].verdict.found_share) worst = i;
  }
  if (worst < 0) return false;
  dead_[worst] = 1;
  active_.erase(std::find(active_.begin(), active_.end(), worst));
  return true;
}

/// What failed may be asked again, unless it lies below the table.
void SceneSearch::revive(int i) {
  std::string reason;
  if (dead_[i] && !below_table(candidates_[i], reason)) dead_[i] = 0;
}

void SceneSearch::settle() {
  const std::vector<int> before = active_;
  // Two objects that hide each other fail alone: what is nearly good enough is asked again.
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    if (candidates_[i].alone.log_odds > kMayBeLogOdds) revive(static_cast<int>(i));
  }
  fill();
  while (remove_worst()) fill();
  const bool grown = std::any_of(active_.begin(), active_.end(), [&](int i) {
    return !std::count(before.begin(), before.end(), i);
  });
  if (!grown) return;
  // What failed alone may be hidden by what is new.
  for (std::size_t i = 0; i < candidates_.size(); ++i) revive(static_cast<int>(i));
  fill();
  while (remove_worst()) fill();
}

}  // namespace trihedron
