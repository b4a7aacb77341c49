// SPDX-License-Identifier: Apache-2.0
#include "recognition/glance.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/projected_model.hpp"

namespace trihedron {
namespace {

/// Behind a known object means behind by more than this, mm: a hypothesis is off by as much.
constexpr double kBehindMm = 5;

/// A model's vertices and surfaces as a camera sees them.
struct Seen {
  std::vector<Eigen::Vector2d> pixels;  // vertices
  std::vector<double> depths;           // vertices, mm
  std::vector<char> front;              // surfaces
};

void look(const Camera& camera, const Model& model, const Transform& world_from_model, Seen& seen) {
  const Transform camera_from_model = camera.camera_from_world * world_from_model;
  const bool pinhole = camera.projection == Camera::Projection::kPinhole;
  seen.pixels.clear();
  seen.depths.clear();
  bool in_front = true;
  for (const Eigen::Vector3d& vertex : model.mesh.vertices) {
    const Eigen::Vector3d x = camera_from_model * vertex;
    in_front = in_front && (!pinhole || x.z() > 1.0);
    seen.pixels.push_back(camera.project_camera(x));
    seen.depths.push_back(x.z());
  }
  seen.front.clear();
  for (const Surface& surface : model.surfaces) {
    const Eigen::Vector3d normal = camera_from_model.R * surface.normal;
    const double offset = surface.offset + normal.dot(camera_from_model.t);
    const double distance = (camera_from_model * surface.centroid).norm();
    seen.front.push_back(in_front && faces_camera(camera, normal, offset, distance));
  }
}

/// An image line and the depths of its ends, mm.
struct Line {
  Eigen::Vector2d x0, x1;
  double depth0, depth1;
};

void append_line(const Camera& camera, const Line& line, int view, std::vector<GlancePoint>& out) {
  constexpr double kStepPx = 16;  // independent answers
  const Eigen::Vector2d along = line.x1 - line.x0;
  const int count = static_cast<int>(along.norm() / kStepPx);
  const int bin = ContourField::bin_of(-along.y(), along.x());
  for (int i = 0; i < count; ++i) {
    const double s = (i + 0.5) / count;
    const Eigen::Vector2d x = line.x0 + s * along;
    if (!(x.x() >= 0 && x.y() >= 0 && x.x() < camera.width_px && x.y() < camera.height_px))
      continue;
    out.push_back({static_cast<std::int16_t>(x.x()), static_cast<std::int16_t>(x.y()),
                   static_cast<std::uint8_t>(view), static_cast<std::uint8_t>(bin),
                   static_cast<float>((1 - s) * line.depth0 + s * line.depth1)});
  }
}

}  // namespace

std::vector<GlancePoint> glance_points(const std::vector<FieldView>& views, const Model& model,
                                       const Transform& world_from_model) {
  std::vector<GlancePoint> out;
  Seen seen;
  for (std::size_t v = 0; v < views.size(); ++v) {
    look(*views[v].camera, model, world_from_model, seen);
    for (const ModelEdge& edge : model.edges) {
      const bool left = seen.front[edge.left], right = seen.front[edge.right];
      if ((!left && !right) || (!edge.convex && left != right)) continue;
      const Line line{seen.pixels[edge.v0], seen.pixels[edge.v1], seen.depths[edge.v0],
                      seen.depths[edge.v1]};
      append_line(*views[v].camera, line, static_cast<int>(v), out);
    }
  }
  return out;
}

std::vector<GlancePoint> visible_glance_points(const std::vector<FieldView>& views,
                                               const PlacedModel& placed) {
  std::vector<GlancePoint> out;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Camera& camera = *views[v].camera;
    const auto depth = [&](const Eigen::Vector3d& x) { return (camera.camera_from_world * x).z(); };
    for (const VisibleEdge& e : visible_edges(camera, {placed})) {
      const Line line{e.x0, e.x1, depth(e.x0_in_world), depth(e.x1_in_world)};
      append_line(camera, line, static_cast<int>(v), out);
    }
  }
  return out;
}

Remainder remainder(const std::vector<FieldView>& views, const std::vector<PlacedModel>& known) {
  Remainder out;
  for (const FieldView& view : views) {
    out.maps.push_back(spread_map(*view.field, visible_edges(*view.camera, known)));
    out.surfaces.push_back(surface_map(*view.camera, known));
  }
  return out;
}

GlanceScorer::GlanceScorer(const std::vector<SpreadMap>& all, const Remainder& rest)
    : GlanceScorer(rest.maps) {
  all_ = &all;
  rest_ = &rest;
}

GlanceScorer::GlanceScorer(const std::vector<SpreadMap>& maps) : maps_(maps) {
  constexpr double kHit = 0.9, kMiss = 0.1;  // of an edge that is there
  for (const SpreadMap& map : maps) {
    for (const double density : map.density) {
      const double chance = std::clamp(density, 0.01, 0.9);
      odds_.push_back({{std::log(kMiss / (1 - chance)), std::log(kHit / chance)}});
    }
  }
}

/// Whether a known object hides the point, or has the contour that is there.
bool GlanceScorer::silent(const GlancePoint& p) const {
  const float depth = rest_->surfaces[p.view].depth_at(p.x, p.y);
  if (depth < p.depth - static_cast<float>(kBehindMm)) return true;
  return (*all_)[p.view].near(p.x, p.y, p.bin) && !maps_[p.view].near(p.x, p.y, p.bin);
}

double GlanceScorer::score(const std::vector<GlancePoint>& points) const {
  double sum = 0;
  for (const GlancePoint& p : points) {
    if (rest_ && silent(p)) continue;
    const Odds& odds = odds_[static_cast<std::size_t>(p.view) * ContourField::kBins + p.bin];
    sum += odds.answer[maps_[p.view].near(p.x, p.y, p.bin)];
  }
  return sum;
}

}  // namespace trihedron
