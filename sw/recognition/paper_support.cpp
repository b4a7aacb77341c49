// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

/// The coordinates that top, side and front measure.
constexpr std::array<std::array<int, 2>, 3> kMeasured = {{{0, 1}, {0, 2}, {1, 2}}};

double cross(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// One half of the convex hull, left to right.
template <typename Iterator>
Points half_hull(Iterator first, Iterator last) {
  Points hull;
  for (; first != last; ++first) {
    while (hull.size() > 1 && cross(hull[hull.size() - 2], hull.back(), *first) <= 0) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  return hull;
}

/// Counter-clockwise.
Points convex_hull(Points points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Points hull = half_hull(points.begin(), points.end());
  const Points back = half_hull(points.rbegin(), points.rend());
  hull.insert(hull.end(), back.begin() + 1, back.end() - 1);
  return hull;
}

bool inside(const Points& hull, const Vector2d& p) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (cross(hull[i], hull[(i + 1) % hull.size()], p) < 0) return false;
  }
  return true;
}

Vector2d flat(const Eigen::Vector3d& p, std::size_t role) {
  return {p[kMeasured[role][0]], p[kMeasured[role][1]]};
}

Points project(const Model& model, const Transform& world_from_model, std::size_t role) {
  Points vertices;
  for (const Eigen::Vector3d& v : model.mesh.vertices) {
    vertices.push_back(flat(world_from_model * v, role));
  }
  return vertices;
}

bool explains(const Points& vertices, const Vector2d& corner, double tolerance_mm) {
  return std::any_of(vertices.begin(), vertices.end(), [&](const Vector2d& v) {
    return (v - corner).cwiseAbs().maxCoeff() <= tolerance_mm;
  });
}

}  // namespace

CornerSupport corner_support(const MeasuredCorners& corners, const Model& model,
                             const Transform& world_from_model, double tolerance_mm) {
  CornerSupport support;
  for (std::size_t role = 0; role < 3; ++role) {
    const Points vertices = project(model, world_from_model, role);
    const Points hull = convex_hull(vertices);
    support.outline += static_cast<int>(hull.size());
    for (const Vector2d& v : hull) {
      support.found += std::any_of(corners[role].begin(), corners[role].end(), [&](const auto& c) {
        return explains({v}, flat(c, role), tolerance_mm);
      });
    }
    for (const Eigen::Vector3d& c : corners[role]) {
      const Vector2d corner = flat(c, role);
      const bool explained = explains(vertices, corner, tolerance_mm);
      support.explained += explained;
      support.inside += explained || inside(hull, corner);
    }
  }
  return support;
}

MeasuredCorners unexplained_corners(const MeasuredCorners& corners, const Model& model,
                                    const Transform& world_from_model, double tolerance_mm) {
  MeasuredCorners left;
  for (std::size_t role = 0; role < 3; ++role) {
    const Points vertices = project(model, world_from_model, role);
    for (const Eigen::Vector3d& c : corners[role]) {
      if (!explains(vertices, flat(c, role), tolerance_mm)) left[role].push_back(c);
    }
  }
  return left;
}

}  // namespace trihedron
