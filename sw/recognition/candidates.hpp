// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "recognition/glance.hpp"
#include "recognition/hypotheses.hpp"
#include "recognition/model_facts.hpp"
#include "recognition/verification.hpp"

namespace trihedron {

/// Further hypotheses once some objects are known: their contours and what they hide left out.
using MoreHypotheses =
    std::function<std::vector<PoseHypothesis>(const std::vector<PlacedModel>& known)>;

/// What the search for an explanation works on; all of it outlives the search.
struct SceneInput {
  std::vector<FieldView> views;
  std::vector<SpreadMap> maps;  ///< per view, of all contours
  const std::vector<Model>& library;
  const ModelFacts& facts;                 ///< of the library
  std::vector<PoseHypothesis> hypotheses;  ///< the search adds to them
  MoreHypotheses more;                     ///< may be empty
};

/// Mean distance in mm of the vertices of `model` between two poses, symmetries allowed for.
double pose_distance(const Model& model, const Transform& a, const Transform& b);

/// A hypothesis and how well it agrees at a glance.
struct RankedHypothesis {
  double score = 0;  ///< log likelihood ratio against chance
  int hypothesis = 0;
};

/// How far contours are looked for around a hypothesis, one search after another, mm.
inline const std::vector<double> kHypothesisReachesMm = {5, 2.5, 1};
/// Refinement moves a hypothesis by less, mm: the reaches together.
inline constexpr double kRefinedByMm = 8.5;

/// Log likelihood ratio at a glance below which a hypothesis need not be refined. A claim needs 40
/// of the evidence in the end, whatever else speaks for it (verification.cpp); half of that must be
/// seen at once.
inline constexpr double kLeastAtAGlance = 20;

/// Ranks the hypotheses of a scene by how well they agree with maps of the contours, no hidden
/// lines removed. What a hypothesis predicts is worked out once, for all its rankings.
class Ranker {
 public:
  /// Poses that reach below `floor_mm`, world z, are left out.
  Ranker(const SceneInput& input, double floor_mm);

  /// Takes in hypotheses added to the input since.
  void update();

  /// At most `count` hypotheses of at least kLeastAtAGlance, best first, none near a better one of
  /// the same model.
  std::vector<RankedHypothesis> rank(const GlanceScorer& scorer, int count) const;

 private:
  struct Prediction {
    std::vector<GlancePoint> points;  ///< none of a pose that is left out
    Eigen::Vector3d vertex_mean;      ///< world, mm
  };
  bool same(int a, int b) const;

  const SceneInput& input_;
  double floor_mm_;
  std::vector<Prediction> predictions_;  ///< per hypothesis
};

/// World z of a pose's lowest vertex, mm.
double lowest(const Model& model, const Transform& world_from_model);

/// A hypothesis on its way to become an object.
struct Candidate {
  int model = 0;  ///< index into the library
  RefinedPose pose;
  Verdict alone;    ///< as if nothing hid it but what was known when it was proposed
  Verdict verdict;  ///< among the others
};

/// Refines hypothesis `index` and judges it, `known` objects in front of it.
Candidate make_candidate(const SceneInput& input, int index,
                         const std::vector<PlacedModel>& known = {});
/// The same for any pose near the truth: contours are searched for up to `reaches_mm` away.
Candidate make_candidate(const SceneInput& input, int model, const Transform& world_from_model,
                         const std::vector<double>& reaches_mm,
                         const std::vector<PlacedModel>& known = {});

}  // namespace trihedron
