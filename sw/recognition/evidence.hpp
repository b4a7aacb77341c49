// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/model.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

struct EvidenceOptions {
  double tolerance_px = 3;      ///< of a projected edge from a segment, across: before refinement
  double tolerance_rad = 0.12;  ///< between their directions
  double sample_px = 10;        ///< spacing of the samples along a projected edge
  /// A visible edge of an object that is there shows a segment with this probability: internal
  /// edges are often weak, and other objects hide some.
  double hit_probability = 0.7;
};

/// How well poses agree with the segments of all views: a quick look-up, no visibility but the
/// side of the surfaces.
class Evidence {
 public:
  Evidence(const std::vector<ViewLines>& views, const EvidenceOptions& options = {});

  /// Log likelihood ratio "the object is there" against "segments are there by chance", summed
  /// over samples along all edges that turn a surface to a camera. At most `max_samples` per edge.
  double score(const Model& model, const Transform& world_from_model, int max_samples) const;

  /// The same, and moves the pose to reduce the distances of hit samples: one Gauss-Newton step.
  double refine(const Model& model, Transform& world_from_model) const;

  /// Segments (numbered through all views) that the pose's edges hit.
  std::vector<int> explained(const Model& model, const Transform& world_from_model) const;

 private:
  struct Grid;
  template <typename Visitor>
  void visit(const Model& model, const Transform& pose, int max_samples, Visitor&& visitor) const;
  int find(std::size_t view, const Eigen::Vector2d& p, const Eigen::Vector2d& direction) const;

  struct Grid {
    int columns = 0, rows = 0;
    std::vector<std::int32_t> start;    ///< per cell: its range in `segment`
    std::vector<std::int32_t> segment;  ///< segments that pass near the cell
  };

  const std::vector<ViewLines>& views_;
  EvidenceOptions options_;
  std::vector<Grid> grids_;
  std::vector<int> first_;  ///< per view: number of its first segment
  std::vector<double> log_hit_, log_miss_;
  double cosine_;
};

}  // namespace trihedron
