// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper_verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace trihedron {
namespace {

/// Of the cosines of the angles between normals (eq. 21).
constexpr double kCosineTolerance = 0.28;
/// Of the distances between centroids, relative to the model's (eq. 22).
constexpr double kDistanceTolerance = 0.10;
/// The states grow exponentially with the surfaces that agree; scenes of five objects need a
/// few thousand.
constexpr std::size_t kMaxStates = 100000;

/// The correspondences of one model and which of them may follow each other.
struct PairGraph {
  std::vector<PaperMatch> nodes;       ///< ascending in scene surface
  std::vector<std::vector<int>> arcs;  ///< per node
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
      if (error <= 1) graph.arcs[a].push_back(static_cast<int>(b));
    }
  }
  return graph;
}

/// Walks the tree of all paths. Paths over the same surfaces that end on the same one continue
/// alike, so that each such state is walked once.
class PathSearch {
 public:
  explicit PathSearch(const PairGraph& graph) : graph_(graph) {}

  SequenceSearch run() {
    for (int start = 0; start < static_cast<int>(graph_.nodes.size()); ++start) {
      path_ = {start};
      walked_.clear();
      extend();
    }
    SequenceSearch result;
    result.truncated = states_ >= kMaxStates;
    for (const std::vector<int>& nodes : closed_) {
      PaperSequence& sequence = result.sequences.emplace_back();
      for (const int n : nodes) sequence.push_back(graph_.nodes[static_cast<std::size_t>(n)]);
    }
    std::stable_sort(result.sequences.begin(), result.sequences.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return result;
  }

 private:
  const PaperMatch& node(int n) const { return graph_.nodes[static_cast<std::size_t>(n)]; }

  void extend() {
    std::vector<int> set = path_;
    std::sort(set.begin(), set.end());
    if (states_ >= kMaxStates || !walked_.insert({set, path_.back()}).second) return;
    ++states_;
    for (const int next : graph_.arcs[static_cast<std::size_t>(path_.back())]) {
      if (next == path_.front()) closed_.insert(set);
      if (!may_follow(next)) continue;
      path_.push_back(next);
      extend();
      path_.pop_back();
    }
  }

  /// Every closed path is walked from its lowest scene surface; no surface occurs twice.
  bool may_follow(int next) const {
    const PaperMatch m = node(next);
    if (m.scene_surface <= node(path_.front()).scene_surface) return false;
    return std::none_of(path_.begin(), path_.end(), [&](int n) {
      return node(n).scene_surface == m.scene_surface || node(n).model_surface == m.model_surface;
    });
  }

  const PairGraph& graph_;
  std::vector<int> path_;
  std::set<std::pair<std::vector<int>, int>> walked_;
  std::set<std::vector<int>> closed_;
  std::size_t states_ = 0;
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

SequenceSearch closed_sequences(const std::vector<SurfaceAttributes>& scene,
                                const std::vector<SurfaceAttributes>& model,
                                const std::vector<std::vector<int>>& candidates) {
  return PathSearch(make_graph(scene, model, candidates)).run();
}

}  // namespace trihedron
