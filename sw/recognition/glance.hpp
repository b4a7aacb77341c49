// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "recognition/refinement.hpp"
#include "recognition/spread_map.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

/// A point that a pose predicts on the image of one of the model's edges.
struct GlancePoint {
  std::int16_t x, y;  ///< px
  std::uint8_t view;
  std::uint8_t bin;  ///< direction of the edge's normal
  float depth;       ///< camera z, mm
};

/// The points of a pose in all views, 16 px apart and inside the images, on the edges that turn a
/// surface to the camera, no hidden lines removed.
std::vector<GlancePoint> glance_points(const std::vector<FieldView>& views, const Model& model,
                                       const Transform& world_from_model);
/// The same of the edges that can be seen, hidden lines removed.
std::vector<GlancePoint> visible_glance_points(const std::vector<FieldView>& views,
                                               const PlacedModel& placed);

/// What known objects leave of a scene for others, per view.
struct Remainder {
  std::vector<SpreadMap> maps;       ///< contours that the objects do not explain
  std::vector<SurfaceMap> surfaces;  ///< of the objects: what lies behind cannot be seen
};

Remainder remainder(const std::vector<FieldView>& views, const std::vector<PlacedModel>& known);

/// Scores points against a map per view: the log likelihood ratio of "the model is there" against
/// chance. The points of a pose are found once and scored against many maps, which costs a
/// nanosecond a point.
class GlanceScorer {
 public:
  explicit GlanceScorer(const std::vector<SpreadMap>& maps);
  /// Scores what known objects leave: points that they hide, or whose contour they explain, say
  /// nothing. `all` are the maps of all contours.
  GlanceScorer(const std::vector<SpreadMap>& all, const Remainder& rest);

  double score(const std::vector<GlancePoint>& points) const;

 private:
  /// What a point adds, by view and bin.
  struct Odds {
    double answer[2];  ///< [0]: no contour near, [1]: one
  };
  bool silent(const GlancePoint& point) const;

  const std::vector<SpreadMap>& maps_;
  std::vector<Odds> odds_;  ///< view * kBins + bin
  const std::vector<SpreadMap>* all_ = nullptr;
  const Remainder* rest_ = nullptr;
};

}  // namespace trihedron
