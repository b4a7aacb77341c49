// SPDX-License-Identifier: Apache-2.0
#include "report/drawn_layers.hpp"

#include <algorithm>
#include <cmath>

#include "recognition/regions.hpp"

namespace trihedron::report {
namespace {

/// A boundary as a flat list.
Json loop(const ImagePolygon& polygon) {
  Json list = Json::array();
  for (const Eigen::Vector2d& x : polygon) append(list, x);
  return list;
}

/// Where the lens puts an undistorted position.
Eigen::Vector2d as_taken(const Camera& camera, const IdealView& ideal, const Eigen::Vector2d& x) {
  constexpr double kAheadMm = 1;  // any point of the ray serves
  const Ray ray = ideal.ray(x);
  return camera.project(ray.origin + kAheadMm * ray.direction);
}

/// A visible piece of a model edge; a lens with distortion bends it, hence the steps.
Json piece(const Camera& camera, const VisibleEdge& edge) {
  constexpr double kStepPx = 32;
  const bool bent = std::any_of(camera.distortion.begin(), camera.distortion.end(),
                                [](double k) { return k != 0; });
  const int steps = bent ? std::max(1, static_cast<int>(edge.length_px / kStepPx)) : 1;
  Json line = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    append(line, camera.project(edge.x0_in_world + s * (edge.x1_in_world - edge.x0_in_world)));
  }
  return {{"crease", edge.type == EdgeType::kCrease}, {"line", line}};
}

}  // namespace

Json vertex_layer(const ViewFeatures& features) {
  Json list = Json::array();
  for (const Vertex& v : features.vertices)
    list.push_back({v.x, v.y, v.branches, v.pattern, v.strength});
  return list;
}

Json region_layer(const ViewFeatures& features) {
  Json list = Json::array();
  for (const Region& region : find_regions(features)) {
    Json boundaries = Json::array();
    boundaries.push_back(loop(region.outer));
    for (const ImagePolygon& hole : region.holes) boundaries.push_back(loop(hole));
    list.push_back(boundaries);
  }
  return list;
}

Json segment_layer(const ViewLines& lines, const Camera& camera) {
  Json list = Json::array();
  for (const Segment& segment : lines.segments) {
    Json line = numbers(as_taken(camera, lines.ideal, segment.p0));
    append(line, as_taken(camera, lines.ideal, segment.p1));
    list.push_back(line);
  }
  return list;
}

Json edge_layer(const Camera& camera, const std::vector<PlacedModel>& objects, int index) {
  Json list = Json::array();
  for (const VisibleEdge& edge : visible_edges(camera, objects, index))
    list.push_back(piece(camera, edge));
  return list;
}

Json residual_layer(const FieldView& view, const std::vector<PlacedModel>& objects, int index) {
  // The spacing, and the way kept from the pieces' ends, of the last rounds of refine().
  constexpr double kStepPx = 4, kEndPx = 4;
  Json list = Json::array();
  const std::vector<VisibleEdge> edges = visible_edges(*view.camera, objects, index);
  for (const EdgePoint& point : edge_points(view, 0, edges, kStepPx, kEndPx)) {
    Json sample = numbers(point.x);
    const EdgeProfile profile = view.field->profile(point.x, point.normal);
    if (speaks(profile)) append(sample, Eigen::Vector2d(profile.offset_px * point.normal));
    list.push_back(sample);
  }
  return list;
}

}  // namespace trihedron::report
