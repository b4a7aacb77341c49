// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <vector>

#include "recognition/lookalikes.hpp"
#include "recognition/solid_overlap.hpp"

namespace trihedron {

/// Solids of verified poses penetrate each other by less, mm: the poses' errors.
inline constexpr double kPenetrationMm = 2.0;

/// What the search asks of a model only once the model is in question: worked out then and kept
/// for all later scenes, so that a library of thousands costs nothing at the start. Threads may
/// share it.
class ModelFacts {
 public:
  /// `library` outlives the facts.
  explicit ModelFacts(const std::vector<Model>& library)
      : library_(library), facts_(library.size()) {}

  /// Points kPenetrationMm inside a model; by its index in the library.
  const InnerPoints& inner(int model) const;
  /// What can be taken for a model; by its index in the library.
  const Lookalikes& lookalikes(int model) const;

 private:
  struct Facts {
    std::once_flag inner_known, lookalikes_known;
    InnerPoints inner;
    Lookalikes lookalikes;
  };

  const std::vector<Model>& library_;
  mutable std::vector<Facts> facts_;
};

}  // namespace trihedron
