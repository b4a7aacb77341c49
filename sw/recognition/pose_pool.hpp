// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "recognition/evidence.hpp"
#include "recognition/hypotheses.hpp"
#include "recognition/model.hpp"

namespace trihedron {

/// Collects poses, scores those that are new, and hands out the best, refined and merged.
class PosePool {
 public:
  PosePool(const Evidence& evidence, const std::vector<Model>& library, const LibraryIndex& index,
           const HypothesisOptions& options)
      : evidence_(evidence), library_(library), index_(index), options_(options) {}

  /// Scores the pose unless it is hopeless or enough poses like it were scored before.
  void add(int model, const Transform& world_from_model);

  /// Refines the best poses added since the last call on the segments and merges equal ones (up
  /// to a symmetry); all settled poses so far, best first.
  const std::vector<PoseHypothesis>& settle();

  int offered() const { return offered_; }
  int scored() const { return scored_; }

 private:
  std::uint64_t bin(int model, const Transform& pose) const;
  Eigen::Vector3d vertex_mean(const PoseHypothesis& h) const;
  bool same(const PoseHypothesis& a, const PoseHypothesis& b, double limit_mm) const;
  void merge(std::vector<PoseHypothesis>& poses, double limit) const;

  const Evidence& evidence_;
  const std::vector<Model>& library_;
  const LibraryIndex& index_;
  const HypothesisOptions& options_;
  std::vector<PoseHypothesis> fresh_, settled_;
  /// A claim needs 40 of the evidence in the end (kLeastAtAGlance), and samples are closer than
  /// independent answers. Before refinement, by two samples an edge, a quarter of that.
  static constexpr double kLeastSupport = 40, kLeastCoarse = 10;

  double floor_ = kLeastCoarse;                   ///< fresh poses must have more support
  std::unordered_map<std::uint64_t, int> count_;  ///< poses scored per bin
  int offered_ = 0, scored_ = 0;
};

}  // namespace trihedron
