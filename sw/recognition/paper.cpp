// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper.hpp"

#include <algorithm>
#include <chrono>

#include "recognition/crossing_error.hpp"

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

PaperScene scene_of(const std::array<PlanarView, 3>& planar, const RegionsByRole& regions,
                    const PaperTrace& trace) {
  PaperScene scene;
  for (const CrossedSurface& surface : trace.surfaces) {
    scene.surfaces.push_back(surface.attributes);
    scene.loops.push_back(surface.loops);
  }
  scene.corners = measure_corners(planar, regions);
  scene.error_mm = trace.error_mm;
  return scene;
}

/// Surer with more surfaces, then with a smaller positioning error.
double score_of(const PaperIdentification& id, double diameter_mm) {
  const auto surfaces = static_cast<double>(id.matches.size());
  return surfaces / (surfaces + 1 + std::min(1.0, id.position.error_mm / diameter_mm));
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
                                      score_of(id, model(id).diameter), id.reason});
      }
    }
    std::stable_sort(result->objects.begin(), result->objects.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
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
    add_runner_up(id, &out);
    return out;
  }

  /// The next model in the list that wanted one of these surfaces.
  void add_runner_up(const PaperIdentification& id, RecognizedObject* out) const {
    for (const PaperIdentification& other : trace_.priority_list) {
      if (other.accepted || !share_surface(id, other)) continue;
      out->runner_up_model_id = model(other).id;
      out->runner_up_score = score_of(other, model(other).diameter);
      return;
    }
  }

  const std::vector<Model>& library_;
  const std::array<PlanarView, 3>& planar_;
  const PaperTrace& trace_;
};

/// Fills the trace's hypotheses and priority list; `lap` is called between the two with the number
/// of hypotheses.
template <typename Lap>
void identify(const PaperScene& scene, const std::vector<Model>& library, const Lap& lap,
              PaperTrace* trace) {
  std::vector<PaperModel> models;
  for (const Model& model : library) models.push_back(paper_model(model));
  std::size_t hypotheses = 0;
  for (const SurfaceAttributes& surface : scene.surfaces) {
    trace->hypotheses.push_back(paper_hypotheses(surface, models));
    for (const PaperHypothesis& h : trace->hypotheses.back()) hypotheses += h.surfaces.size();
  }
  lap(hypotheses);
  trace->priority_list = identify_models(scene, library, models, trace->hypotheses);
}

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

  RecognitionResult result;
  Stopwatch watch;
  const auto lap = [&](const char* stage, std::size_t count) {
    result.stages.push_back({stage, static_cast<int>(count), watch.lap()});
  };
  const RegionsByRole regions = regions_by_role(views, planar, trace);
  lap("regions", regions[0].size() + regions[1].size() + regions[2].size());
  make_surfaces(planar, regions, library, trace);
  lap("surfaces", trace->surfaces.size());
  const PaperScene scene = scene_of(planar, regions, *trace);
  identify(
      scene, library, [&](std::size_t count) { lap("hypotheses", count); }, trace);
  Report(library, planar, *trace).write(&result);
  lap("poses", result.objects.size());
  trace->seconds = result.stages[2].seconds + result.stages[3].seconds;
  return result;
}

}  // namespace trihedron
