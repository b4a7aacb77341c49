// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "recognition/paper_hypotheses.hpp"
#include "recognition/paper_positioning.hpp"
#include "recognition/paper_verification.hpp"

namespace trihedron {

/// What became of one model of the priority list.
struct PaperIdentification {
  int model = 0;          ///< index into the library
  PaperSequence matches;  ///< identified surfaces
  PaperPosition position;
  bool truncated = false;  ///< the path search ended early
  bool accepted = false;
  std::string reason;  ///< why not
};

/// The priority list: for every model that some position fits, the best combination of its
/// surfaces, by decreasing number of identified surfaces, then corners explained, then
/// positioning error. `hypotheses` is V_i per scene surface.
///
/// A model is accepted when none of its surfaces belongs to a model before it and the outline of
/// the reconstructed model is in the views. A combination may be a single surface, which no pair
/// verifies: then, of the corners that the models before it left over, it must explain at least as
/// many elsewhere as the surface itself has.
std::vector<PaperIdentification> identify_models(
    const PaperScene& scene, const std::vector<Model>& library,
    const std::vector<PaperModel>& models,
    const std::vector<std::vector<PaperHypothesis>>& hypotheses);

/// Whether both name the same scene surface somewhere.
bool share_surface(const PaperIdentification& a, const PaperIdentification& b);

}  // namespace trihedron
