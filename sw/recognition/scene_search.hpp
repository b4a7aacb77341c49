// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recognition/candidates.hpp"
#include "recognition/lookalikes.hpp"
#include "recognition/similar_shapes.hpp"
#include "recognition/solid_overlap.hpp"

namespace trihedron {

struct SceneSearchOptions {
  int ranked = 120;  ///< hypotheses kept in a ranking
  int batch = 4;     ///< refined before the scene is looked at anew
  int patience = 2;  ///< batches without a new object before the search ends
  /// The same once more hypotheses have come: fewer, and ranked by what the objects leave.
  int patience_for_more = 1;
  bool table = true;  ///< nothing lies below the world's z = 0
};

/// Looks for the set of candidates that explains the scene together. Greedy: the best batch of
/// hypotheses is refined and tried, all objects so far are judged with each other in front, the
/// worst one that fails goes; contours explained by the objects leave the next ranking.
class SceneSearch {
 public:
  SceneSearch(SceneInput& input, const SceneSearchOptions& options);

  void run();

  const std::vector<Candidate>& candidates() const { return candidates_; }
  /// The explanation: indices into candidates(), most evidence first.
  std::vector<int> objects() const;
  /// The best other candidate for an object's place, -1: none.
  int runner_up(int object) const;
  /// All that stands in the scene as placed, candidate i among it, and its position there.
  std::vector<PlacedModel> context_of(int i, int& position) const;

 private:
  /// Why a claim cannot be made, "": it can; and what may stand in its place instead.
  struct Doubt {
    std::string reason;
    PlacedModel instead;
  };

  PlacedModel placed(int i) const;
  const InnerPoints& inner(int model) const { return input_.facts.inner(model); }
  std::vector<int> standing_with(int i) const;
  bool in_conflict(int a, int b);
  bool known(const Candidate& candidate) const;
  void reject(int i, const std::string& reason);
  bool below_table(const Candidate& candidate, std::string& reason) const;

  std::vector<RankedHypothesis> rank_rest();
  void search(int patience);
  bool ask_for_more();
  bool try_batch();
  bool explains_all(int candidate);
  void add(int hypothesis);
  void add(const Candidate& candidate);
  void fill();
  void judge(int i);
  bool remove_worst();
  void revive(int i);
  void settle();
  double at_a_glance(const PlacedModel& object) const;
  void find_rivals(int winner);
  void add_turned(int winner);
  std::optional<Transform> explains_more(int winner, const Model& shape, const Transform& pose,
                                         const std::vector<double>& reaches_mm,
                                         double enough) const;
  Doubt mirrored_as_good(int winner) const;
  Doubt block_is_better(int winner) const;
  SimilarShapes stretched(int winner) const;
  Doubt similar_is_better(int winner);
  int best_rival(int winner);
  Doubt doubt_about(int winner);
  double lead(int winner) const;
  void withdraw(int i, const Doubt& doubt);
  void settle_rivals(int winner);
  bool is_rival(int i, int winner);
  void settle_all(std::map<int, std::vector<int>>& settled_in);
  int best_refused(const std::set<int>& asked);
  bool last_improves();
  bool reconsider(std::set<int>& asked);
  void settle_rivals();

  /// Other poses and shapes in an object's place are looked at when their quick score reaches this
  /// share of its own.
  static constexpr double kRivalShare = 0.7;
  /// How far contours are looked for around the poses of lookalikes, mm: they are known to
  /// kCoincide of the diameter.
  static const std::vector<double> kLookalikeReachesMm;

  SceneInput& input_;
  SceneSearchOptions options_;
  Ranker ranker_;
  GlanceScorer all_contours_;
  std::vector<RankedHypothesis> first_ranking_;  ///< by all contours
  std::vector<Candidate> candidates_;
  std::vector<char> dead_;
  std::vector<int> active_;  ///< what stands in the scene
  /// Of active ones that are not claimed: what stands there. Whatever it is, it hides what lies
  /// behind it and has its contours.
  std::map<int, PlacedModel> instead_;
  std::list<Model> shapes_;                    ///< of those that are in no library
  std::vector<char> tried_;                    ///< hypotheses
  std::map<int, std::vector<int>> judged_in_;  ///< the neighbours an object was last judged with
  std::map<int, int> runner_up_;
};

}  // namespace trihedron
