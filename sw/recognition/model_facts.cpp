// SPDX-License-Identifier: Apache-2.0
#include "recognition/model_facts.hpp"

namespace trihedron {

const InnerPoints& ModelFacts::inner(int model) const {
  const auto i = static_cast<std::size_t>(model);
  Facts& facts = facts_[i];
  std::call_once(facts.inner_known,
                 [&] { facts.inner = inner_points(library_[i], kPenetrationMm); });
  return facts.inner;
}

const Lookalikes& ModelFacts::lookalikes(int model) const {
  const auto i = static_cast<std::size_t>(model);
  Facts& facts = facts_[i];
  std::call_once(facts.lookalikes_known, [&] { facts.lookalikes = find_lookalikes(library_[i]); });
  return facts.lookalikes;
}

}  // namespace trihedron
