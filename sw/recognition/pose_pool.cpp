// SPDX-License-Identifier: Apache-2.0
#include "recognition/pose_pool.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Vector3d;

void sort_best(std::vector<PoseHypothesis>& h, int count) {
  std::stable_sort(h.begin(), h.end(), [](const PoseHypothesis& a, const PoseHypothesis& b) {
    return a.support > b.support;
  });
  if (h.size() > static_cast<std::size_t>(count)) h.resize(static_cast<std::size_t>(count));
}

/// A pose from a corner may be tilted by the errors of two directions in the image, and be off by a
/// few pixels. What reaches deeper below z = 0 is an accident, as about half of all poses are.
bool reaches_below_table(const ModelSketch& model, const Transform& pose) {
  constexpr double kTilt = 0.1, kOffMm = 10;
  return model.lowest(pose) < -(kOffMm + kTilt * model.diameter);
}

}  // namespace

/// A number that poses within a bin share: 5 mm for the model's first surface, about 6 degrees.
std::uint64_t PosePool::bin(int model, const Transform& pose) const {
  constexpr double kBinMm = 5, kBinsPerUnit = 10;
  const Vector3d x = pose * library_[static_cast<std::size_t>(model)].surfaces[0].centroid;
  std::uint64_t hash = 14695981039346656037ULL;
  const auto mix = [&](double v) {
    hash ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v)) + (1 << 20));
    hash *= 1099511628211ULL;
    hash ^= hash >> 29;
  };
  mix(model);
  for (int k = 0; k < 3; ++k) mix(x[k] / kBinMm);
  for (int k = 0; k < 2; ++k) {
    for (int l = 0; l < 3; ++l) mix(pose.R(l, k) * kBinsPerUnit + 0.5);
  }
  return hash;
}

void PosePool::add(int model, const Transform& pose) {
  ++offered_;
  // Nearly all poses are accidents, and to see that is cheaper than to look for equal ones.
  const ModelSketch& sketch = index_.sketch(model);
  if (options_.table && reaches_below_table(sketch, pose)) return;
  if (evidence_.hopeless(sketch, pose)) return;
  if (floor_ > kLeastCoarse && evidence_.score_at_most(sketch, pose, true) <= floor_) return;
  constexpr int kPerBin = 2;
  if (++count_[bin(model, pose)] > kPerBin) return;
  ++scored_;
  const PoseHypothesis h{model, pose, evidence_.score(sketch, pose, 2)};
  if (h.support <= floor_) return;
  fresh_.push_back(h);
  // What is not among the best now will not be later.
  if (fresh_.size() < 2 * static_cast<std::size_t>(options_.max_coarse)) return;
  sort_best(fresh_, options_.max_coarse);
  floor_ = std::max(floor_, fresh_.back().support);
}

Vector3d PosePool::vertex_mean(const PoseHypothesis& h) const {
  return h.world_from_model * index_.sketch(h.model).vertex_mean;
}

/// Whether two poses of one model put every vertex in the same place, up to a symmetry.
bool PosePool::same(const PoseHypothesis& a, const PoseHypothesis& b, double limit_mm) const {
  const Model& m = library_[static_cast<std::size_t>(a.model)];
  const auto close = [&](const Transform& pose) {
    return std::all_of(m.mesh.vertices.begin(), m.mesh.vertices.end(), [&](const Vector3d& x) {
      return (pose * x - b.world_from_model * x).squaredNorm() < limit_mm * limit_mm;
    });
  };
  if (close(a.world_from_model)) return true;
  return std::any_of(m.symmetries.begin(), m.symmetries.end(),
                     [&](const Transform& s) { return close(a.world_from_model * s); });
}

/// Keeps the first of equal poses, in order; `limit` is a share of the diameter.
void PosePool::merge(std::vector<PoseHypothesis>& poses, double limit) const {
  struct Kept {
    std::size_t index;
    Vector3d mean;
  };
  std::unordered_map<int, std::vector<Kept>> kept_of_model;
  std::vector<PoseHypothesis> out;
  for (const PoseHypothesis& h : poses) {
    std::vector<Kept>& kept = kept_of_model[h.model];
    const double limit_mm = limit * index_.sketch(h.model).diameter;
    const Vector3d mean = vertex_mean(h);
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Kept& other) {
      // Poses that agree in every vertex agree in the vertices' mean, whatever the symmetry.
      return (mean - other.mean).squaredNorm() < limit_mm * limit_mm &&
             same(h, out[other.index], limit_mm);
    });
    if (known) continue;
    kept.push_back({out.size(), mean});
    out.push_back(h);
  }
  poses = std::move(out);
}

const std::vector<PoseHypothesis>& PosePool::settle() {
  constexpr double kSameBefore = 0.04, kSameAfter = 0.03;  // of the diameter, refinement between
  sort_best(fresh_, options_.max_coarse);
  merge(fresh_, kSameBefore);
  for (PoseHypothesis& h : fresh_) {
    const ModelSketch& sketch = index_.sketch(h.model);
    for (const int samples : {2, 4}) evidence_.refine(sketch, h.world_from_model, samples);
    h.support = evidence_.score(sketch, h.world_from_model, 8);
  }
  const auto weak = [](const PoseHypothesis& h) { return h.support < kLeastSupport; };
  fresh_.erase(std::remove_if(fresh_.begin(), fresh_.end(), weak), fresh_.end());
  settled_.insert(settled_.end(), fresh_.begin(), fresh_.end());
  fresh_.clear();
  floor_ = kLeastCoarse;
  sort_best(settled_, options_.max_coarse);
  merge(settled_, kSameAfter);
  sort_best(settled_, options_.max_hypotheses);
  return settled_;
}

}  // namespace trihedron
