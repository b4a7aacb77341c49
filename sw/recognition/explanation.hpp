// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/candidates.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

struct ExplanationOptions {
  CandidateOptions candidates;
  bool table = true;  ///< nothing lies below the world's z = 0
};

/// What stands in the scene, and what does not and why.
struct Explanation {
  std::vector<RecognizedObject> objects;  ///< by decreasing score
  std::vector<Rejection> rejections;      ///< refined hypotheses, most evidence first
};

/// The set of objects that explains the views together: each of them verified with the others
/// in front of it, none in another's place, none where two different answers are equally good.
/// `views` and `library` must outlive the call only. Deterministic.
Explanation explain(const std::vector<View>& views, const std::vector<Model>& library,
                    const std::vector<PoseHypothesis>& hypotheses,
                    const ExplanationOptions& options = {});

}  // namespace trihedron
