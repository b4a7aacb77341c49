// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper_verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trihedron {
namespace {

/// Of the cosines of the angles between normals (eq. 21).
constexpr double kCosineTolerance = 0.28;
/// Of the distances between centroids, relative to the model's (eq. 22).
constexpr double kDistanceTolerance = 0.10;
/// Longest closed paths grow exponentially with the surfaces in the scene; ten times what the
/// search visits in scenes of five objects.
constexpr int kMaxVisits = 200000;

/// The correspondences of one model and which of them may follow each other.
struct PairGraph {
  std::vector<PaperMatch> nodes;  ///< ascending in scene surface
  struct Arc {
    int node;
    double error;
  };
  std::vector<std::vector<Arc>> arcs;  ///< per node, smallest error first
};

PairGraph make_graph(const std::vector<SurfaceAttributes>& scene,
                     const std::vector<SurfaceAttributes>& model,
                     const std::vector<std::vector<int>>& candidates) {
  PairGraph graph;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (const int surface : candidates[i]) graph.nodes.push_back({static_cast<int>(i), surface});
  }
  graph.arcs.resize(graph.nodes.size());
  for (std::size_t a = 0; a < graph.nodes.size(); ++a) {
    for (std::size_t b = 0; b < graph.nodes.size(); ++b) {
      const PaperMatch &p = graph.nodes[a], &q = graph.nodes[b];
      if (p.scene_surface == q.scene_surface || p.model_surface == q.model_surface) continue;
      const double error = pair_error(scene[static_cast<std::size_t>(p.scene_surface)],
                                      scene[static_cast<std::size_t>(q.scene_surface)],
                                      model[static_cast<std::size_t>(p.model_surface)],
                                      model[static_cast<std::size_t>(q.model_surface)]);
      if (error <= 1) graph.arcs[a].push_back({static_cast<int>(b), error});
    }
    std::stable_sort(graph.arcs[a].begin(), graph.arcs[a].end(),
                     [](const auto& x, const auto& y) { return x.error < y.error; });
  }
  return graph;
}

/// Depth-first search of the tree of all paths, cut off where a path cannot beat the best one.
class PathSearch {
 public:
  PathSearch(const PairGraph& graph, std::size_t scene_surfaces, std::size_t model_surfaces)
      : graph_(graph), scene_used_(scene_surfaces), model_used_(model_surfaces) {}

  PaperSequence run() {
    best_.error = std::numeric_limits<double>::infinity();
    for (std::size_t start = 0; start < graph_.nodes.size(); ++start) {
      start_ = static_cast<int>(start);
      extend(start_, 0);
    }
    best_.truncated = visits_ > kMaxVisits;
    if (best_.matches.empty()) best_.error = 0;
    return best_;
  }

 private:
  /// Scene surfaces that the path could still take: those after its first one.
  std::size_t reachable() const {
    std::size_t count = 0;
    int last = node(start_).scene_surface;
    for (std::size_t n = static_cast<std::size_t>(start_); n < graph_.nodes.size(); ++n) {
      const int s = graph_.nodes[n].scene_surface;
      count += s != last && !scene_used_[static_cast<std::size_t>(s)];
      last = s;
    }
    return count;
  }

  bool hopeless(double error) const {
    const std::size_t longest = path_.size() + reachable();
    return longest < best_.matches.size() ||
           (longest == best_.matches.size() && error >= best_.error);
  }

  void extend(int n, double error) {
    if (++visits_ > kMaxVisits) return;
    const PaperMatch match = node(n);
    path_.push_back(match);
    scene_used_[static_cast<std::size_t>(match.scene_surface)] = true;
    model_used_[static_cast<std::size_t>(match.model_surface)] = true;
    if (!hopeless(error)) {
      for (const PairGraph::Arc& arc : graph_.arcs[static_cast<std::size_t>(n)]) {
        follow(arc, error + arc.error);
      }
    }
    path_.pop_back();
    scene_used_[static_cast<std::size_t>(match.scene_surface)] = false;
    model_used_[static_cast<std::size_t>(match.model_surface)] = false;
  }

  void follow(const PairGraph::Arc& arc, double error) {
    if (arc.node == start_) return close(error);
    const PaperMatch next = node(arc.node);
    // every closed path is found once, from its lowest scene surface
    if (next.scene_surface <= node(start_).scene_surface) return;
    if (scene_used_[static_cast<std::size_t>(next.scene_surface)] ||
        model_used_[static_cast<std::size_t>(next.model_surface)]) {
      return;
    }
    extend(arc.node, error);
  }

  void close(double error) {
    const std::size_t length = path_.size(), best = best_.matches.size();
    if (length < best || (length == best && error >= best_.error)) return;
    best_.matches = path_;
    best_.error = error;
  }

  const PaperMatch& node(int n) const { return graph_.nodes[static_cast<std::size_t>(n)]; }

  const PairGraph& graph_;
  std::vector<bool> scene_used_, model_used_;
  std::vector<PaperMatch> path_;
  PaperSequence best_;
  int start_ = 0;
  int visits_ = 0;
};

}  // namespace

double pair_error(const SurfaceAttributes& a, const SurfaceAttributes& b,
                  const SurfaceAttributes& v, const SurfaceAttributes& w) {
  const double cosine = std::abs(a.normal.dot(b.normal) - v.normal.dot(w.normal));
  const double model_distance = (v.centroid - w.centroid).norm();
  const double distance = std::abs((a.centroid - b.centroid).norm() - model_distance);
  if (model_distance == 0 && distance > 0) return std::numeric_limits<double>::infinity();
  const double relative = model_distance > 0 ? distance / model_distance : 0;
  return std::max(cosine / kCosineTolerance, relative / kDistanceTolerance);
}

PaperSequence best_sequence(const std::vector<SurfaceAttributes>& scene,
                            const std::vector<SurfaceAttributes>& model,
                            const std::vector<std::vector<int>>& candidates) {
  const PairGraph graph = make_graph(scene, model, candidates);
  return PathSearch(graph, scene.size(), model.size()).run();
}

}  // namespace trihedron
