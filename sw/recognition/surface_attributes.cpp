// SPDX-License-Identifier: Apache-2.0
#include "recognition/surface_attributes.hpp"

#include <Eigen/Geometry>

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// Twice the area vector of a polygon, about `origin` (Newell).
Vector3d twice_area_vector(const SpacePolygon& loop, const Vector3d& origin) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += (loop[i] - origin).cross(loop[(i + 1) % loop.size()] - origin);
  }
  return sum;
}

void add_edges(const SpacePolygon& loop, SurfaceAttributes* out) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector3d& a = loop[i];
    const Vector3d& b = loop[(i + 1) % loop.size()];
    out->edge_lengths.push_back((b - a).norm());
    out->edge_middles.push_back(0.5 * (a + b));
    out->perimeter += out->edge_lengths.back();
  }
}

}  // namespace

SurfaceAttributes surface_attributes(const std::vector<SpacePolygon>& loops) {
  SurfaceAttributes out;
  if (loops.empty() || loops[0].size() < 3) return out;
  const Vector3d origin = loops[0][0];
  Vector3d area_vector = Vector3d::Zero();
  for (const SpacePolygon& loop : loops) {
    area_vector += 0.5 * twice_area_vector(loop, origin);
    add_edges(loop, &out);
  }
  out.area = area_vector.norm();
  if (out.area == 0) return out;
  out.normal = area_vector / out.area;
  Vector3d moment = Vector3d::Zero();  // of the triangles (origin, a, b), about the origin
  for (const SpacePolygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector3d a = loop[i] - origin, b = loop[(i + 1) % loop.size()] - origin;
      moment += a.cross(b).dot(out.normal) / 6 * (a + b);
    }
  }
  out.centroid = origin + moment / out.area;
  return out;
}

std::vector<SpacePolygon> surface_loops(const Model& model, int index) {
  std::vector<SpacePolygon> loops;
  for (const std::vector<int>& loop : model.surfaces[static_cast<std::size_t>(index)].loops) {
    SpacePolygon& points = loops.emplace_back();
    for (const int v : loop) points.push_back(model.mesh.vertices[static_cast<std::size_t>(v)]);
  }
  return loops;
}

SurfaceAttributes surface_attributes(const Model& model, int index) {
  return surface_attributes(surface_loops(model, index));
}

}  // namespace trihedron
