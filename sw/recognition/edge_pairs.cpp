// SPDX-License-Identifier: Apache-2.0
#include "recognition/edge_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/symmetry.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;

class PairSearch {
 public:
  PairSearch(const std::vector<ViewLines>& views, const std::vector<Model>& library,
             const LibraryIndex& index, PosePool& pool)
      : views_(views), library_(library), index_(index), pool_(pool) {}

  void match(const SpaceEdge& a, const SpaceEdge& b, double tolerance) {
    a_ = &a;
    b_ = &b;
    tolerance_ = tolerance;
    for (std::size_t k = 0; k < 4; ++k) distance_[k] = (a.end[k / 2] - b.end[k % 2]).norm();
    // Touching edges are corners; edges that belong to different objects are mostly far apart.
    if (*std::min_element(distance_.begin(), distance_.end()) < tolerance) return;
    for (const DirectedEdge& first :
         index_.edges_by_length(a.length - tolerance, a.length + tolerance)) {
      match_first(first);
    }
  }

 private:
  void match_first(const DirectedEdge& first) {
    const Model& model = library_[static_cast<std::size_t>(first.model)];
    const double longest = *std::max_element(distance_.begin(), distance_.end());
    if (longest > model.diameter + tolerance_) return;
    const auto [begin, end] =
        index_.sketch(first.model)
            .edges_by_length(b_->length - tolerance_, b_->length + tolerance_);
    for (const ModelSketch::Edge* e = begin; e != end; ++e) {
      if (e->index == first.edge) continue;
      match_second(model, first, {first.model, e->index, e->v0, e->v1, e->length});
      match_second(model, first, {first.model, e->index, e->v1, e->v0, e->length});
    }
  }

  void match_second(const Model& model, const DirectedEdge& first, const DirectedEdge& second) {
    const auto at = [&](int v) -> const Vector3d& {
      return model.mesh.vertices[static_cast<std::size_t>(v)];
    };
    const int vertex[4] = {first.from, first.to, second.from, second.to};
    for (std::size_t k = 0; k < 4; ++k) {
      const double d = (at(vertex[k / 2]) - at(vertex[2 + k % 2])).norm();
      if (std::abs(d - distance_[k]) > tolerance_) return;
    }
    const std::vector<Vector3d> x_in_model = {at(vertex[0]), at(vertex[1]), at(vertex[2]),
                                              at(vertex[3])};
    const std::vector<Vector3d> x = {a_->end[0], a_->end[1], b_->end[0], b_->end[1]};
    const Transform pose = best_motion(x_in_model, x);
    for (std::size_t k = 0; k < 4; ++k) {
      // Mirrored pairs have the same distances but do not fit.
      if ((pose * x_in_model[k] - x[k]).norm() > tolerance_) return;
    }
    if (visible(model, first.edge, pose, *a_) && visible(model, second.edge, pose, *b_)) {
      pool_.add(first.model, pose);
    }
  }

  /// Whether one of the surfaces at an edge turns to each of the views that show it.
  bool visible(const Model& model, int edge, const Transform& pose, const SpaceEdge& seen) const {
    const ModelEdge& e = model.edges[static_cast<std::size_t>(edge)];
    for (std::size_t v = 0; v < views_.size(); ++v) {
      if (seen.segment[v] < 0) continue;
      const Vector3d sight = pose.R.transpose() * views_[v].ideal.sight(seen.end[0]);
      if (model.surfaces[static_cast<std::size_t>(e.left)].normal.dot(sight) >= 0 &&
          model.surfaces[static_cast<std::size_t>(e.right)].normal.dot(sight) >= 0) {
        return false;
      }
    }
    return true;
  }

  const std::vector<ViewLines>& views_;
  const std::vector<Model>& library_;
  const LibraryIndex& index_;
  PosePool& pool_;
  const SpaceEdge* a_ = nullptr;
  const SpaceEdge* b_ = nullptr;
  double tolerance_ = 0;              // mm
  std::array<double, 4> distance_{};  // a0 b0, a0 b1, a1 b0, a1 b1
};

}  // namespace

void poses_from_edge_pairs(const std::vector<ViewLines>& views, const std::vector<SpaceEdge>& edges,
                           const std::vector<Model>& library, const LibraryIndex& index,
                           const HypothesisOptions& options, const Claims& claimed,
                           PosePool& pool) {
  double largest = 0;
  for (const Model& m : library) largest = std::max(largest, m.diameter);
  std::vector<const SpaceEdge*> whole;
  for (const SpaceEdge& e : edges) {
    if (e.agreed[0] && e.agreed[1] && !all_claimed(e, claimed)) whole.push_back(&e);
  }
  PairSearch search(views, library, index, pool);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (std::size_t j = i + 1; j < whole.size(); ++j) {
      const double tolerance =
          options.length_tolerance_px * std::max(whole[i]->end_mm_per_px, whole[j]->end_mm_per_px);
      if ((whole[i]->end[0] - whole[j]->end[0]).norm() > largest + tolerance) continue;
      search.match(*whole[i], *whole[j], tolerance);
    }
  }
}

}  // namespace trihedron
