// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/direction_map.hpp"
#include "recognition/index.hpp"
#include "recognition/segment_grid.hpp"
#include "recognition/spoke.hpp"
#include "recognition/transform.hpp"
#include "recognition/view_lanes.hpp"

namespace trihedron {

/// Per view and segment: whether a pose explains it well.
using Claims = std::vector<std::vector<char>>;

/// Whether all segments of an edge are claimed.
bool all_claimed(const SpaceEdge& edge, const Claims& claimed);

struct EvidenceOptions {
  double tolerance_px = 3;      ///< of a projected edge from a segment, across: before refinement
  double tolerance_rad = 0.12;  ///< between their directions, as a sine
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
  double score(const ModelSketch& model, const Transform& world_from_model, int max_samples) const;

  /// No less than score() of one or two samples per edge, in a fraction of its time; or far below
  /// 0 as soon as hopeless() would be certain.
  float score_at_most(const ModelSketch& model, const Transform& world_from_model,
                      bool two_samples) const;

  /// Whether the pose is so unlikely that score() need not be asked: Wald's sequential test on one
  /// sample per edge and view, stopped once the evidence against the pose is overwhelming; or all
  /// of them together speak against it. Most accidental poses end after a dozen samples.
  bool hopeless(const ModelSketch& model, const Transform& world_from_model) const;

  /// The evidence, as of score_at_most, along an edge that leaves `x` in the unit direction `d`, up
  /// to `length_mm`. Per view: it counts from `from_mm` on; beyond any length where it cannot be
  /// seen or is known.
  void ask_along(const Eigen::Vector3d& x, const Eigen::Vector3d& d,
                 const std::vector<double>& from_mm, double length_mm, Spoke& out) const;

  /// Moves the pose to reduce the distances of hit samples: one Gauss-Newton step.
  void refine(const ModelSketch& model, Transform& world_from_model, int max_samples) const;

  /// Marks the segments that the pose's edges hit, per view, if the hit share of all samples
  /// reaches `min_share`.
  void claim(const ModelSketch& model, const Transform& world_from_model, double min_share,
             Claims& claimed) const;

 private:
  /// A sample of a projected edge.
  struct Sample {
    std::size_t view;
    const ModelSketch::Edge* edge;
    float along;  ///< 0: at v0, 1: at v1
    int segment;  ///< of the view, that it hits, or SegmentGrid::kMiss
  };

  template <typename Visitor>
  void visit(const ModelSketch& model, const Transform& pose, int max_samples,
             Visitor&& visitor) const;

  const std::vector<ViewLines>& views_;
  EvidenceOptions options_;
  std::vector<LaneRig> rigs_;
  std::vector<SegmentGrid> grids_;          ///< per view
  std::vector<DirectionMap> maps_;          ///< per view
  std::vector<double> log_hit_, log_miss_;  ///< per view
  std::vector<std::array<float, 2>> odds_;  ///< per view: of a miss and of a hit, the same
};

}  // namespace trihedron
