// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// What can be taken for a model: itself in other poses, its mirror image, and a plain block.
struct Lookalikes {
  /// Motions that put the model onto most of its own edges and are no symmetries.
  std::vector<Transform> turned;
  /// The mirror image, unless a motion maps it onto the model.
  std::optional<Model> mirrored;
  /// model_from_mirrored: motions that put the mirror image onto most of the model's edges.
  std::vector<Transform> mirrored_onto;
  /// The block that the model just fits into, in the model's place, unless it is the model.
  std::optional<Model> block;
};

/// The model as a mirror shows it: x becomes -x.
Model mirror_image(const Model& model);

/// The block with the model's extent along the axes of its frame.
Model bounding_block(const Model& model);

/// At most kLookalikes of either kind, the most alike first.
inline constexpr int kLookalikes = 8;
Lookalikes find_lookalikes(const Model& model);

}  // namespace trihedron
