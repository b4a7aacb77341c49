// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper_identification.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace trihedron {
namespace {

using Candidates = std::vector<std::vector<int>>;

/// Per scene surface, the surfaces of model k that it may be.
Candidates candidates_of(const std::vector<std::vector<PaperHypothesis>>& hypotheses, int k) {
  Candidates candidates;
  for (const std::vector<PaperHypothesis>& per_surface : hypotheses) {
    candidates.emplace_back();
    for (const PaperHypothesis& h : per_surface) {
      if (h.model == k) candidates.back() = h.surfaces;
    }
  }
  return candidates;
}

/// The closed sequences, longest first, and last every single surface.
SequenceSearch combinations(const PaperScene& scene, const PaperModel& model,
                            const Candidates& candidates) {
  SequenceSearch search = closed_sequences(scene.surfaces, model.surfaces, candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (const int c : candidates[i]) search.sequences.push_back({{static_cast<int>(i), c}});
  }
  return search;
}

/// Positions with the model's outline in the views first, then those consistent with the views,
/// then more identified surfaces, then the better position.
bool better(const PaperIdentification& a, const PaperIdentification& b) {
  const CornerSupport &p = a.position.support, &q = b.position.support;
  if (p.outlined() != q.outlined()) return p.outlined();
  if (p.consistent() != q.consistent()) return p.consistent();
  if (a.matches.size() != b.matches.size()) return a.matches.size() > b.matches.size();
  return a.position.better_than(b.position);
}

bool cannot_be_beaten(const PaperIdentification& best, const PaperSequence& next) {
  const CornerSupport& support = best.position.support;
  return support.outlined() && support.consistent() && next.size() < best.matches.size();
}

std::optional<PaperIdentification> best_combination(const PaperScene& scene, const Model& model,
                                                    const PaperModel& attributes,
                                                    const Candidates& candidates, int k) {
  const SequenceSearch search = combinations(scene, attributes, candidates);
  std::optional<PaperIdentification> best;
  for (const PaperSequence& sequence : search.sequences) {
    if (best && cannot_be_beaten(*best, sequence)) break;
    const auto position = position_model(scene, model, attributes.surfaces, sequence);
    if (!position) continue;
    PaperIdentification found{k, sequence, *position, search.truncated, false, ""};
    if (!best || better(found, *best)) best = std::move(found);
  }
  return best;
}

/// Goes through the list in order of priority.
class Acceptance {
 public:
  Acceptance(const PaperScene& scene, const std::vector<Model>& library)
      : scene_(scene), library_(library), left_(scene.corners) {}

  void run(std::vector<PaperIdentification>* list) {
    for (PaperIdentification& id : *list) {
      id.reason = reason_against(id, *list);
      id.accepted = id.reason.empty();
      if (!id.accepted) continue;
      left_ = unexplained_corners(left_, model(id), id.position.world_from_model,
                                  scene_.tolerance_mm());
    }
  }

 private:
  const Model& model(const PaperIdentification& id) const {
    return library_[static_cast<std::size_t>(id.model)];
  }

  std::string reason_against(const PaperIdentification& id,
                             const std::vector<PaperIdentification>& list) const {
    for (const PaperIdentification& other : list) {
      if (other.accepted && share_surface(id, other)) {
        return "its surfaces belong to model " + std::to_string(model(other).id) +
               ", which is before it in the priority list";
      }
    }
    const CornerSupport& s = id.position.support;
    if (!s.outlined()) {
      return "only " + std::to_string(s.found) + " of " + std::to_string(s.outline) +
             " corners of its outline are in the views";
    }
    if (id.matches.size() > 1) return "";
    const int explained =
        corner_support(left_, model(id), id.position.world_from_model, scene_.tolerance_mm())
            .explained;
    const auto surface = static_cast<std::size_t>(id.matches[0].scene_surface);
    if (explained >= 2 * scene_.surfaces[surface].edges()) return "";
    return "a single surface, and the model explains only " + std::to_string(explained) +
           " corners that no other model explains";
  }

  const PaperScene& scene_;
  const std::vector<Model>& library_;
  MeasuredCorners left_;
};

}  // namespace

bool share_surface(const PaperIdentification& a, const PaperIdentification& b) {
  for (const PaperMatch& m : a.matches) {
    for (const PaperMatch& n : b.matches) {
      if (m.scene_surface == n.scene_surface) return true;
    }
  }
  return false;
}

std::vector<PaperIdentification> identify_models(
    const PaperScene& scene, const std::vector<Model>& library,
    const std::vector<PaperModel>& models,
    const std::vector<std::vector<PaperHypothesis>>& hypotheses) {
  std::vector<PaperIdentification> list;
  for (std::size_t k = 0; k < library.size(); ++k) {
    const int index = static_cast<int>(k);
    auto best =
        best_combination(scene, library[k], models[k], candidates_of(hypotheses, index), index);
    if (best) list.push_back(std::move(*best));
  }
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.matches.size() != b.matches.size() ? a.matches.size() > b.matches.size()
                                                : a.position.better_than(b.position);
  });
  Acceptance(scene, library).run(&list);
  return list;
}

}  // namespace trihedron
