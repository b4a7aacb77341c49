// SPDX-License-Identifier: Apache-2.0
// Ear clipping with holes: each hole is first joined to the outer boundary by a bridge.
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "recognition/model_surfaces.hpp"

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Points = std::vector<Vector2d>;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the signed area of a triangle, positive counter-clockwise.
double area2(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return cross(b - a, c - a);
}

/// Whether the open segments ab and cd cross.
bool segments_cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  return area2(a, b, c) * area2(a, b, d) < 0 && area2(c, d, a) * area2(c, d, b) < 0;
}

/// Whether the corner at b of the counter-clockwise path a, b, c opens towards p.
bool in_corner(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& p) {
  const bool left_of_ab = area2(a, b, p) > 0, left_of_bc = area2(b, c, p) > 0;
  return area2(a, b, c) > 0 ? left_of_ab && left_of_bc : left_of_ab || left_of_bc;
}

/// Whether the segment from outline[i] to vertex `to` meets no side of any boundary.
bool is_free(const Points& p, const std::vector<int>& outline,
             const std::vector<std::vector<int>>& holes, int from, int to) {
  const auto blocked = [&](const std::vector<int>& loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int c = loop[k], d = loop[(k + 1) % loop.size()];
      if (segments_cross(p[from], p[to], p[c], p[d])) return true;
      const Vector2d along = p[to] - p[from];
      if (c == from || c == to || area2(p[from], p[to], p[c]) != 0) continue;
      const double s = (p[c] - p[from]).dot(along);
      if (s > 0 && s < along.squaredNorm()) return true;  // runs through a corner
    }
    return false;
  };
  return !blocked(outline) && std::none_of(holes.begin(), holes.end(), blocked);
}

/// The outline with the nearest hole that a free bridge reaches spliced in; the hole is removed.
bool splice_hole(const Points& p, std::vector<int>& outline, std::vector<std::vector<int>>& holes) {
  double best = std::numeric_limits<double>::infinity();
  std::size_t best_i = 0, best_hole = 0, best_k = 0;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t hole = 0; hole < holes.size(); ++hole)
      for (std::size_t k = 0; k < holes[hole].size(); ++k) {
        const int from = outline[i], to = holes[hole][k];
        const double distance = (p[from] - p[to]).squaredNorm();
        if (distance >= best || distance == 0) continue;
        if (!in_corner(p[outline[(i + n - 1) % n]], p[from], p[outline[(i + 1) % n]], p[to]))
          continue;
        if (!is_free(p, outline, holes, from, to)) continue;
        best = distance;
        best_i = i;
        best_hole = hole;
        best_k = k;
      }
  if (best == std::numeric_limits<double>::infinity()) return false;
  std::vector<int> inner = holes[best_hole];
  std::rotate(inner.begin(), inner.begin() + static_cast<std::ptrdiff_t>(best_k), inner.end());
  inner.push_back(inner.front());
  inner.push_back(outline[best_i]);
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(best_i) + 1, inner.begin(),
                 inner.end());
  holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(best_hole));
  return true;
}

/// Smallest angle measure of an ear, larger is better; negative when it is none.
double ear_quality(const Points& p, const std::vector<int>& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const int a = outline[(i + n - 1) % n], b = outline[i], c = outline[(i + 1) % n];
  const double area = area2(p[a], p[b], p[c]);
  if (area <= 0) return -1;
  for (int v : outline) {
    if (v == a || v == b || v == c) continue;
    if (area2(p[a], p[b], p[v]) >= 0 && area2(p[b], p[c], p[v]) >= 0 &&
        area2(p[c], p[a], p[v]) >= 0)
      return -1;
  }
  const double longest = std::max(
      {(p[a] - p[b]).squaredNorm(), (p[b] - p[c]).squaredNorm(), (p[c] - p[a]).squaredNorm()});
  return area / longest;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<Vector3d>& vertices,
                                            const std::vector<std::vector<int>>& loops,
                                            const Vector3d& normal) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Points p(vertices.size());
  for (const auto& loop : loops)
    for (int i : loop) p[i] = {u.dot(vertices[i]), v.dot(vertices[i])};

  std::vector<int> outline = loops[0];
  std::vector<std::vector<int>> holes(loops.begin() + 1, loops.end());
  while (!holes.empty() && splice_hole(p, outline, holes)) {
  }
  std::vector<std::array<int, 3>> out;
  while (outline.size() >= 3) {
    const std::size_t n = outline.size();
    std::size_t best = 0;
    double quality = -1;
    for (std::size_t i = 0; i < n; ++i) {
      const double q = ear_quality(p, outline, i);
      if (q > quality) {
        quality = q;
        best = i;
      }
    }
    if (quality >= 0)
      out.push_back({outline[(best + n - 1) % n], outline[best], outline[(best + 1) % n]});
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return out;
}

}  // namespace trihedron
