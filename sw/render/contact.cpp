// SPDX-License-Identifier: Apache-2.0
#include "render/contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "render/stable_pose.hpp"

namespace trihedron::render {
namespace {

constexpr double kLevel_mm = 1e-3;  // faces this near to a height lie at it

using Polygon = std::vector<Eigen::Vector2d>;

struct Box {
  Eigen::Vector3d low, high;
  explicit Box(const Body& body) : low(body.vertices[0]), high(body.vertices[0]) {
    for (const Eigen::Vector3d& v : body.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
  }
  bool meets(const Box& b) const {
    return (low.array() <= b.high.array()).all() && (b.low.array() <= high.array()).all();
  }
};

// How often the segment from p along d (one length) crosses the body's surface.
int crossings(const Eigen::Vector3d& p, const Eigen::Vector3d& d, const Body& body) {
  int count = 0;
  for (const std::array<int, 3>& t : body.triangles) {
    const Eigen::Vector3d& a = body.vertices[t[0]];
    const Eigen::Vector3d u = body.vertices[t[1]] - a, v = body.vertices[t[2]] - a;
    const Eigen::Vector3d q = d.cross(v);
    const double det = u.dot(q);
    if (det == 0) continue;
    const Eigen::Vector3d s = p - a, r = s.cross(u);
    const double f = s.dot(q) / det, g = d.dot(r) / det, along = v.dot(r) / det;
    if (f >= 0 && g >= 0 && f + g <= 1 && along >= 0 && along <= 1) ++count;
  }
  return count;
}

bool edge_crosses(const Body& a, const Body& b) {
  for (const std::array<int, 3>& t : a.triangles)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d &p = a.vertices[t[k]], &q = a.vertices[t[(k + 1) % 3]];
      if (crossings(p, q - p, b) > 0) return true;
    }
  return false;
}

bool holds(const Body& body, const Eigen::Vector3d& p) {
  // A direction that no edge of a real part follows, longer than any scene.
  return crossings(p, Eigen::Vector3d(12345.6, 23456.7, 54321.0), body) % 2 == 1;
}

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The part of a convex polygon to the left of the line through a and b.
Polygon clip(const Polygon& polygon, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double sp = cross2(b - a, p - a), sq = cross2(b - a, q - a);
    if (sp >= 0) out.push_back(p);
    if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0)) out.push_back(p + sp / (sp - sq) * (q - p));
  }
  return out;
}

// The horizontal triangles at height z that look up (sign +1) or down (-1), counter-clockwise.
std::vector<Polygon> level_triangles(const Body& body, double z, double sign) {
  std::vector<Polygon> out;
  for (const std::array<int, 3>& t : body.triangles) {
    const Eigen::Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]],
                          &c = body.vertices[t[2]];
    const bool level = std::abs(a.z() - z) < kLevel_mm && std::abs(b.z() - z) < kLevel_mm &&
                       std::abs(c.z() - z) < kLevel_mm;
    if (!level || sign * (b - a).cross(c - a).z() <= 0) continue;
    if (sign > 0)
      out.push_back({a.head<2>(), b.head<2>(), c.head<2>()});
    else
      out.push_back({c.head<2>(), b.head<2>(), a.head<2>()});
  }
  return out;
}

Polygon plan(const Body& body) {
  Polygon points;
  for (const Eigen::Vector3d& v : body.vertices) points.push_back(v.head<2>());
  return convex_hull(points);
}

// The widest gap between two convex polygons across an edge of the first.
double gap_across_edges(const Polygon& a, const Polygon& b) {
  double widest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d along = (a[(i + 1) % a.size()] - a[i]).normalized();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& p : b) nearest = std::min(nearest, -cross2(along, p - a[i]));
    widest = std::max(widest, nearest);
  }
  return widest;
}

}  // namespace

Body make_body(const PlacedObject& object) {
  const Mesh& mesh = object.model->mesh;
  Body body;
  for (const Eigen::Vector3d& v : mesh.vertices)
    body.vertices.push_back(object.world_from_model * v);
  body.triangles = mesh.triangles;
  body.mass = object.world_from_model * centre_of_mass(mesh);
  return body;
}

bool interpenetrate(const Body& a, const Body& b) {
  if (!Box(a).meets(Box(b))) return false;
  return edge_crosses(a, b) || edge_crosses(b, a) || holds(a, b.vertices[0]) ||
         holds(b, a.vertices[0]);
}

double gap_in_plan(const Body& a, const Body& b) {
  const Polygon pa = plan(a), pb = plan(b);
  return std::max(gap_across_edges(pa, pb), gap_across_edges(pb, pa));
}

std::vector<Eigen::Vector2d> contact_outline(const Body& lower, const Body& upper, double z) {
  Polygon points;
  const std::vector<Polygon> below = level_triangles(lower, z, 1);
  for (const Polygon& above : level_triangles(upper, z, -1))
    for (const Polygon& t : below) {
      Polygon overlap = above;
      for (int k = 0; k < 3; ++k) overlap = clip(overlap, t[k], t[(k + 1) % 3]);
      points.insert(points.end(), overlap.begin(), overlap.end());
    }
  return convex_hull(points);
}

}  // namespace trihedron::render
