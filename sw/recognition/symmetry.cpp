// SPDX-License-Identifier: Apache-2.0
// A motion that maps a polyhedron onto another maps a directed edge with its left surface onto
// such an edge, and is fixed by that. So one edge of `a` against all edges of `b` gives every
// candidate; the left surface keeps its side, which rules out mirror images.
#include "recognition/symmetry.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <optional>

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// An edge walked in the direction that has `left` on its left hand.
struct DirectedEdge {
  int v0, v1, left, right;
};

std::vector<DirectedEdge> directed_edges(const Model& model) {
  std::vector<DirectedEdge> out;
  for (const ModelEdge& e : model.edges) {
    out.push_back({e.v0, e.v1, e.left, e.right});
    out.push_back({e.v1, e.v0, e.right, e.left});
  }
  return out;
}

/// Origin at the edge's start, x along it, z along the left surface's normal.
Transform frame(const Model& model, const DirectedEdge& e) {
  const Vector3d& origin = model.mesh.vertices[e.v0];
  const Vector3d x = (model.mesh.vertices[e.v1] - origin).normalized();
  const Vector3d y = model.surfaces[e.left].normal.cross(x).normalized();
  Transform out;
  out.R << x, y, x.cross(y);
  out.t = origin;
  return out;
}

bool same_surface(const Surface& a, const Surface& b, double tolerance) {
  return std::abs(a.perimeter - b.perimeter) <=
             2 * tolerance * static_cast<double>(a.loops[0].size()) &&
         std::abs(a.area - b.area) <= tolerance * a.perimeter;
}

/// Cheap comparison of what a motion preserves.
bool may_map(const Model& a, const DirectedEdge& ea, const Model& b, const DirectedEdge& eb,
             double tolerance) {
  const auto length = [](const Model& m, const DirectedEdge& e) {
    return (m.mesh.vertices[e.v1] - m.mesh.vertices[e.v0]).norm();
  };
  return std::abs(length(a, ea) - length(b, eb)) <= 2 * tolerance &&
         same_surface(a.surfaces[ea.left], b.surfaces[eb.left], tolerance) &&
         same_surface(a.surfaces[ea.right], b.surfaces[eb.right], tolerance);
}

int nearest(const std::vector<Vector3d>& points, const Vector3d& x, double within) {
  int best = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i] - x).norm();
    if (distance > within) continue;
    within = distance;
    best = static_cast<int>(i);
  }
  return best;
}

/// The vertices of `b` onto which the motion maps those of `a`, one to one.
std::optional<std::vector<int>> map_vertices(const Model& a, const Model& b,
                                             const Transform& b_from_a, double tolerance) {
  std::vector<int> image;
  std::vector<char> taken(b.mesh.vertices.size(), 0);
  for (const Vector3d& x : a.mesh.vertices) {
    const int v = nearest(b.mesh.vertices, b_from_a * x, tolerance);
    if (v < 0 || taken[v]) return std::nullopt;
    taken[v] = 1;
    image.push_back(v);
  }
  return image;
}

/// Equal vertices do not yet make equal solids: the surfaces must agree too.
bool surfaces_agree(const Model& a, const Model& b, const Transform& b_from_a, double tolerance) {
  for (const Surface& s : a.surfaces) {
    const Vector3d normal = b_from_a.R * s.normal, centroid = b_from_a * s.centroid;
    bool found = false;
    for (const Surface& t : b.surfaces)
      found = found || (normal.dot(t.normal) > 0 && same_surface(s, t, tolerance) &&
                        (centroid - t.centroid).norm() <= 2 * tolerance);
    if (!found) return false;
  }
  return true;
}

std::optional<Transform> complete(const Model& a, const Model& b, const Transform& guess,
                                  double tolerance) {
  // One edge aims less well than all vertices: look further, fit all, then look closely.
  constexpr double kAim = 4;
  const auto image = map_vertices(a, b, guess, kAim * tolerance);
  if (!image) return std::nullopt;
  std::vector<Vector3d> target;
  for (int v : *image) target.push_back(b.mesh.vertices[v]);
  const Transform fitted = best_motion(a.mesh.vertices, target);
  if (map_vertices(a, b, fitted, tolerance) != image) return std::nullopt;
  if (!surfaces_agree(a, b, fitted, tolerance)) return std::nullopt;
  return fitted;
}

}  // namespace

Transform best_motion(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  Eigen::Map<const Eigen::Matrix3Xd> A(a[0].data(), 3, static_cast<Eigen::Index>(a.size()));
  Eigen::Map<const Eigen::Matrix3Xd> B(b[0].data(), 3, static_cast<Eigen::Index>(b.size()));
  const Vector3d mean_a = A.rowwise().mean(), mean_b = B.rowwise().mean();
  const Matrix3d covariance = (B.colwise() - mean_b) * (A.colwise() - mean_a).transpose();
  const Eigen::JacobiSVD<Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d proper = Matrix3d::Identity();
  proper(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  Transform out;
  out.R = svd.matrixU() * proper * svd.matrixV().transpose();
  out.t = mean_b - out.R * mean_a;
  return out;
}

std::vector<Transform> congruences(const Model& a, const Model& b) {
  const double tolerance = kSameShape * a.diameter;
  std::vector<Transform> out;
  if (a.mesh.vertices.size() != b.mesh.vertices.size() || a.edges.size() != b.edges.size() ||
      a.surfaces.size() != b.surfaces.size() || std::abs(a.diameter - b.diameter) > 2 * tolerance)
    return out;
  const std::vector<DirectedEdge> from = directed_edges(a), to = directed_edges(b);
  // The edge of `a` that fewest edges of `b` resemble.
  std::vector<DirectedEdge> candidates = to;
  DirectedEdge key = from[0];
  for (const DirectedEdge& e : from) {
    std::vector<DirectedEdge> similar;
    for (const DirectedEdge& f : to)
      if (may_map(a, e, b, f, tolerance)) similar.push_back(f);
    if (similar.size() >= candidates.size()) continue;
    candidates = similar;
    key = e;
  }
  const Transform key_from_a = frame(a, key).inverse();
  for (const DirectedEdge& f : candidates)
    if (auto motion = complete(a, b, frame(b, f) * key_from_a, tolerance)) out.push_back(*motion);
  return out;
}

bool is_identity(const Transform& motion, const Model& model) {
  for (const Vector3d& x : model.mesh.vertices)
    if ((motion * x - x).norm() > kSameShape * model.diameter) return false;
  return true;
}

}  // namespace trihedron
