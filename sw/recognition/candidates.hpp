// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/hypotheses.hpp"
#include "recognition/verification.hpp"

namespace trihedron {

/// Mean distance in mm of the vertices of `model` between two poses, symmetries allowed for.
double pose_distance(const Model& model, const Transform& a, const Transform& b);

/// A hypothesis on its way to become an object.
struct Candidate {
  int model = 0;  ///< index into the library
  RefinedPose pose;
  Verdict verdict;
};

struct CandidateOptions {
  int quick = 400;   ///< hypotheses that get the quick score, likeliest first
  int refined = 24;  ///< of those that are refined
};

/// A hypothesis' share of points on its possible edges that have a contour of their direction
/// nearby, weighed against chance: a few microseconds.
double quick_score(const std::vector<FieldView>& views, const Model& model,
                   const Transform& world_from_model);

/// The best distinct hypotheses, refined and judged as if nothing hid them, most evidence first.
std::vector<Candidate> find_candidates(const std::vector<FieldView>& views,
                                       const std::vector<ChanceModel>& chance,
                                       const std::vector<Model>& library,
                                       const std::vector<PoseHypothesis>& hypotheses,
                                       const CandidateOptions& options = {});

}  // namespace trihedron
