// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// What can be taken for a model: itself in other poses, and its mirror image.
struct Lookalikes {
  /// Motions that put the model onto most of its own edges and are no symmetries.
  std::vector<Transform> turned;
  /// The mirror image, unless a motion maps it onto the model.
  std::optional<Model> mirrored;
  /// model_from_mirrored: motions that put the mirror image onto most of the model's edges.
  std::vector<Transform> mirrored_onto;
};

/// The model as a mirror shows it: x becomes -x.
Model mirror_image(const Model& model);

/// At most kLookalikes of either kind, the most alike first.
inline constexpr int kLookalikes = 8;
Lookalikes find_lookalikes(const Model& model);

}  // namespace trihedron
