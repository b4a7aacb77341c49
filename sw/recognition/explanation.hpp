// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/recognize.hpp"
#include "recognition/scene_search.hpp"

namespace trihedron {

struct ExplanationOptions {
  SceneSearchOptions search;
};

/// What stands in the scene, and what does not and why.
struct Explanation {
  std::vector<RecognizedObject> objects;  ///< by decreasing score
  std::vector<Rejection> rejections;      ///< refined hypotheses in the order of refinement
  std::vector<SceneSurface> surfaces;     ///< of the objects, as measured in each view
};

/// The set of objects that explains the views together: each of them verified with the others
/// in front of it, none in another's place, none where two different answers are equally good.
/// Deterministic. `edgels` are the views' edge points; `more` is asked once, with the objects found
/// so far; it may be empty.
Explanation explain(const std::vector<View>& views, const std::vector<EdgelMap>& edgels,
                    const std::vector<Model>& library, const ModelFacts& facts,
                    const std::vector<PoseHypothesis>& hypotheses, const MoreHypotheses& more,
                    const ExplanationOptions& options = {});
/// The same with edge points and facts of its own and no more hypotheses.
Explanation explain(const std::vector<View>& views, const std::vector<Model>& library,
                    const std::vector<PoseHypothesis>& hypotheses,
                    const ExplanationOptions& options = {});

}  // namespace trihedron
