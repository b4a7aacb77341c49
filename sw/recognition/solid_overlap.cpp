// SPDX-License-Identifier: Apache-2.0
#include "recognition/solid_overlap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// Grid cells along a model's diameter: fine enough for parts of a tenth of it.
constexpr int kGrid = 14;

double distance_to_surface(const Model& model, const Eigen::Vector3d& x) {
  // The nearest plane bounds the distance from below; exact for the points of interest, which
  // must be far from every surface that is near them.
  double nearest = 1e300;
  for (const ModelEdge& edge : model.edges) {
    const Eigen::Vector3d& a = model.mesh.vertices[edge.v0];
    const Eigen::Vector3d along = model.mesh.vertices[edge.v1] - a;
    const double t = std::clamp(along.dot(x - a) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (x - a - t * along).norm());
  }
  for (const auto& t : model.mesh.triangles) {
    const Eigen::Vector3d& a = model.mesh.vertices[t[0]];
    const Eigen::Vector3d e1 = model.mesh.vertices[t[1]] - a, e2 = model.mesh.vertices[t[2]] - a;
    const Eigen::Vector3d n = e1.cross(e2);
    const Eigen::Vector3d d = x - a;
    const double u = d.cross(e2).dot(n) / n.squaredNorm(), v = e1.cross(d).dot(n) / n.squaredNorm();
    if (u >= 0 && v >= 0 && u + v <= 1) nearest = std::min(nearest, std::abs(n.dot(d)) / n.norm());
  }
  return nearest;
}

Eigen::AlignedBox3d box_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : points) box.extend(x);
  return box;
}

bool shares_points(const PlacedModel& a, const InnerPoints& inner_a, const PlacedModel& b) {
  const Transform b_from_a = b.world_from_model.inverse() * a.world_from_model;
  const Eigen::AlignedBox3d box = box_of(b.model->mesh.vertices);  // outside: not inside
  return std::any_of(inner_a.points.begin(), inner_a.points.end(), [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d x = b_from_a * p;
    return box.contains(x) && inside(*b.model, x);
  });
}

}  // namespace

bool inside(const Model& model, const Eigen::Vector3d& x) {
  // Crossings of a ray in a direction that no face of a manufactured part contains.
  const Eigen::Vector3d direction = Eigen::Vector3d(0.5377, 0.3189, 0.7806).normalized();
  bool in = false;
  for (const auto& t : model.mesh.triangles) {
    const Eigen::Vector3d& a = model.mesh.vertices[t[0]];
    const Eigen::Vector3d e1 = model.mesh.vertices[t[1]] - a, e2 = model.mesh.vertices[t[2]] - a;
    const Eigen::Vector3d p = direction.cross(e2);
    const double det = e1.dot(p);
    if (std::abs(det) < 1e-12) continue;
    const Eigen::Vector3d s = x - a, q = s.cross(e1);
    const double u = s.dot(p) / det, v = direction.dot(q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && e2.dot(q) / det > 0) in = !in;
  }
  return in;
}

InnerPoints inner_points(const Model& model, double margin_mm) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
  for (const Eigen::Vector3d& v : model.mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double step = model.diameter / kGrid;
  InnerPoints out;
  const Eigen::Array3i count = ((high - low) / step).array().ceil().cast<int>();
  for (int i = 0; i < count.prod(); ++i) {
    const Eigen::Vector3d cell(i % count.x(), i / count.x() % count.y(), i / count.x() / count.y());
    const Eigen::Vector3d x =
        low + ((cell.array() + 0.5) * (high - low).array() / count.cast<double>()).matrix();
    if (inside(model, x) && distance_to_surface(model, x) > margin_mm) out.points.push_back(x);
  }
  return out;
}

bool overlap(const PlacedModel& a, const InnerPoints& inner_a, const PlacedModel& b,
             const InnerPoints& inner_b) {
  return shares_points(a, inner_a, b) || shares_points(b, inner_b, a);
}

}  // namespace trihedron
