// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <utility>

#include "recognition/crossing_error.hpp"
#include "recognition/paper_positioning.hpp"

namespace trihedron {
namespace {

class Stopwatch {
 public:
  /// Seconds since construction or the last lap.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

using RegionsByRole = std::array<std::vector<Region>, 3>;

RegionsByRole regions_by_role(const std::vector<View>& views,
                              const std::array<PlanarView, 3>& planar, PaperTrace* trace) {
  RegionsByRole regions;
  for (std::size_t role = 0; role < 3; ++role) {
    regions[role] = find_regions(views[static_cast<std::size_t>(planar[role].view)].features);
    trace->regions[role] = static_cast<int>(regions[role].size());
  }
  return regions;
}

void make_surfaces(const std::array<PlanarView, 3>& planar, const RegionsByRole& regions,
                   const std::vector<Model>& library, PaperTrace* trace) {
  trace->error_mm = crossing_error_mm(planar, library);
  const CrossingResult crossed = cross_views(planar, regions, trace->error_mm);
  trace->incomplete = crossed.incomplete;
  trace->not_planar = crossed.not_planar;
  trace->in_pieces = crossed.in_pieces;
  trace->contradicted = crossed.contradicted;
  trace->surfaces = without_duplicates(crossed.surfaces, table_corner(planar[0]));
  trace->duplicates = static_cast<int>(crossed.surfaces.size() - trace->surfaces.size());
}

/// The library and the scene in the form that identification works on.
struct Identification {
  const std::vector<Model>& library;
  std::vector<PaperModel> models;
  PaperScene scene;
};

Identification prepare(const std::vector<Model>& library, const std::array<PlanarView, 3>& planar,
                       const RegionsByRole& regions, const PaperTrace& trace) {
  Identification work{library, {}, {}};
  for (const Model& model : library) work.models.push_back(paper_model(model));
  for (const CrossedSurface& surface : trace.surfaces) {
    work.scene.surfaces.push_back(surface.attributes);
    work.scene.loops.push_back(surface.loops);
  }
  work.scene.corners = measure_corners(planar, regions);
  work.scene.error_mm = trace.error_mm;
  return work;
}

/// Per scene surface, the surfaces of model k that it may be.
std::vector<std::vector<int>> candidates_of(const PaperTrace& trace, int k) {
  std::vector<std::vector<int>> candidates;
  for (const std::vector<PaperHypothesis>& hypotheses : trace.hypotheses) {
    candidates.emplace_back();
    for (const PaperHypothesis& h : hypotheses) {
      if (h.model == k) candidates.back() = h.surfaces;
    }
  }
  return candidates;
}

/// Positions that are consistent with the views first, then more identified surfaces, then the
/// better position.
bool better(const PaperIdentification& a, const PaperIdentification& b) {
  const bool consistent = a.position.support.consistent();
  if (consistent != b.position.support.consistent()) return consistent;
  if (a.matches.size() != b.matches.size()) return a.matches.size() > b.matches.size();
  return a.position.better_than(b.position);
}

/// The best combination of a model's surfaces. A single surface is one too when its position is
/// consistent with the views.
std::optional<PaperIdentification> identify(const Identification& work, const PaperTrace& trace,
                                            int k) {
  const auto index = static_cast<std::size_t>(k);
  const std::vector<SurfaceAttributes>& surfaces = work.models[index].surfaces;
  const auto candidates = candidates_of(trace, k);
  SequenceSearch search = closed_sequences(work.scene.surfaces, surfaces, candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (const int c : candidates[i]) search.sequences.push_back({{static_cast<int>(i), c}});
  }
  std::optional<PaperIdentification> best;
  for (const PaperSequence& sequence : search.sequences) {
    const bool shorter = best && sequence.size() < best->matches.size();
    if (shorter && best->position.support.consistent()) break;
    const auto position = position_model(work.scene, work.library[index], surfaces, sequence);
    if (!position) continue;
    PaperIdentification found{k, sequence, *position, false, search.truncated};
    if (!best || better(found, *best)) best = std::move(found);
  }
  return best;
}

/// A single surface has no pair that verifies it. Instead the outline of the reconstructed model
/// must be there, and of the corners that the models before it left over it must explain at least
/// as many elsewhere as the surface itself has.
bool single_is_sure(const Identification& work, const MeasuredCorners& left,
                    const PaperIdentification& id) {
  const CornerSupport support =
      corner_support(left, work.library[static_cast<std::size_t>(id.model)],
                     id.position.world_from_model, work.scene.tolerance_mm());
  const auto surface = static_cast<std::size_t>(id.matches[0].scene_surface);
  return id.position.support.outlined() &&
         support.explained >= 2 * work.scene.surfaces[surface].edges();
}

/// By decreasing number of identified surfaces, of equal ones the better position first; models
/// that need a surface of an accepted model are not accepted.
void order_and_accept(const Identification& work, std::vector<PaperIdentification>* list) {
  std::stable_sort(list->begin(), list->end(), [](const auto& a, const auto& b) {
    return a.matches.size() != b.matches.size() ? a.matches.size() > b.matches.size()
                                                : a.position.better_than(b.position);
  });
  std::set<int> taken;
  MeasuredCorners left = work.scene.corners;
  for (PaperIdentification& id : *list) {
    id.accepted = std::none_of(id.matches.begin(), id.matches.end(), [&](const PaperMatch& m) {
      return taken.count(m.scene_surface) > 0;
    });
    if (id.matches.size() == 1) id.accepted = id.accepted && single_is_sure(work, left, id);
    if (!id.accepted) continue;
    for (const PaperMatch& m : id.matches) taken.insert(m.scene_surface);
    left = unexplained_corners(left, work.library[static_cast<std::size_t>(id.model)],
                               id.position.world_from_model, work.scene.tolerance_mm());
  }
}

/// Surer with more surfaces, then with a smaller positioning error.
double score_of(const PaperIdentification& id, double diameter_mm) {
  const auto surfaces = static_cast<double>(id.matches.size());
  return surfaces / (surfaces + 1 + std::min(1.0, id.position.error_mm / diameter_mm));
}

bool share_surface(const PaperIdentification& a, const PaperIdentification& b) {
  for (const PaperMatch& m : a.matches) {
    for (const PaperMatch& n : b.matches) {
      if (m.scene_surface == n.scene_surface) return true;
    }
  }
  return false;
}

class Report {
 public:
  Report(const std::vector<Model>& library, const std::array<PlanarView, 3>& planar,
         const PaperTrace& trace)
      : library_(library), planar_(planar), trace_(trace) {}

  void write(RecognitionResult* result) const {
    for (const CrossedSurface& s : trace_.surfaces) {
      result->surfaces.push_back({view_of(s), s.loops[0], s.attributes.normal,
                                  s.attributes.centroid, s.attributes.area, s.attributes.perimeter,
                                  true});
    }
    for (const PaperIdentification& id : trace_.priority_list) {
      if (id.accepted) {
        result->objects.push_back(object(id));
      } else {
        result->rejections.push_back({model(id).id, id.position.world_from_model,
                                      score_of(id, model(id).diameter), reason(id)});
      }
    }
  }

 private:
  const Model& model(const PaperIdentification& id) const {
    return library_[static_cast<std::size_t>(id.model)];
  }
  int view_of(const CrossedSurface& s) const {
    return planar_[static_cast<std::size_t>(s.role)].view;
  }

  RecognizedObject object(const PaperIdentification& id) const {
    RecognizedObject out;
    out.model_id = model(id).id;
    out.world_from_model = id.position.world_from_model;
    out.score = score_of(id, model(id).diameter);
    out.reprojection_rms_px = id.position.error_mm / planar_[0].mm_per_px;
    for (const PaperMatch& m : id.matches) {
      const CrossedSurface& s = trace_.surfaces[static_cast<std::size_t>(m.scene_surface)];
      out.surfaces.push_back({view_of(s), m.scene_surface, m.model_surface});
    }
    for (const PaperIdentification& other : trace_.priority_list) {
      if (other.accepted || !share_surface(id, other)) continue;
      out.runner_up_model_id = model(other).id;
      out.runner_up_score = score_of(other, model(other).diameter);
      break;
    }
    return out;
  }

  std::string reason(const PaperIdentification& id) const {
    for (const PaperIdentification& other : trace_.priority_list) {
      if (!other.accepted || !share_surface(id, other)) continue;
      return "its surfaces belong to model " + std::to_string(model(other).id) +
             ", which explains more surfaces or fits them better";
    }
    return "not accepted";
  }

  const std::vector<Model>& library_;
  const std::array<PlanarView, 3>& planar_;
  const PaperTrace& trace_;
};

}  // namespace

std::string paper_name(const CrossedSurface& surface) {
  constexpr std::array<char, 3> kLetters = {'s', 'l', 'f'};
  return kLetters[static_cast<std::size_t>(surface.role)] + std::to_string(surface.region + 1);
}

RecognitionResult recognize_paper(const std::vector<View>& views, const std::vector<Model>& library,
                                  const RecognitionOptions&, PaperTrace* trace) {
  PaperTrace local;
  if (!trace) trace = &local;
  *trace = {};
  std::vector<Camera> cameras;
  for (const View& view : views) cameras.push_back(view.camera);
  const std::array<PlanarView, 3> planar = planar_views(cameras);

  Stopwatch watch;
  RecognitionResult result;
  const auto count_of = [](const auto& items) { return static_cast<int>(items.size()); };
  const RegionsByRole regions = regions_by_role(views, planar, trace);
  result.stages.push_back(
      {"regions", trace->regions[0] + trace->regions[1] + trace->regions[2], watch.lap()});

  make_surfaces(planar, regions, library, trace);
  result.stages.push_back({"surfaces", count_of(trace->surfaces), watch.lap()});

  const Identification work = prepare(library, planar, regions, *trace);
  int hypotheses = 0;
  for (const SurfaceAttributes& surface : work.scene.surfaces) {
    trace->hypotheses.push_back(paper_hypotheses(surface, work.models));
    for (const PaperHypothesis& h : trace->hypotheses.back()) hypotheses += count_of(h.surfaces);
  }
  result.stages.push_back({"hypotheses", hypotheses, watch.lap()});

  for (std::size_t k = 0; k < library.size(); ++k) {
    auto identification = identify(work, *trace, static_cast<int>(k));
    if (identification) trace->priority_list.push_back(std::move(*identification));
  }
  order_and_accept(work, &trace->priority_list);
  Report(library, planar, *trace).write(&result);
  result.stages.push_back({"poses", count_of(result.objects), watch.lap()});
  trace->seconds = result.stages[2].seconds + result.stages[3].seconds;
  return result;
}

}  // namespace trihedron
