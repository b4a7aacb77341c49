// SPDX-License-Identifier: Apache-2.0
#include "render/stable_pose.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace trihedron::render {
namespace {

constexpr double kCoplanar_mm = 1e-3;    // vertices of mesh files carry 4 digits and more
constexpr double kSameDirection = 1e-5;  // of unit normals: 10 um over the largest object

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The unit normal, outwards, of the plane through three vertices when no vertex lies beyond it.
std::optional<Eigen::Vector3d> support_normal(const std::vector<Eigen::Vector3d>& v, std::size_t i,
                                              std::size_t j, std::size_t k) {
  Eigen::Vector3d n = (v[j] - v[i]).cross(v[k] - v[i]);
  const double length = n.norm();
  if (length < kCoplanar_mm) return std::nullopt;
  n /= length;
  bool above = false, below = false;
  for (const Eigen::Vector3d& p : v) {
    const double d = n.dot(p - v[i]);
    above |= d > kCoplanar_mm;
    below |= d < -kCoplanar_mm;
    if (above && below) return std::nullopt;
  }
  if (above) n = -n;
  return n;
}

StablePose pose_on(const Mesh& mesh, const Eigen::Vector3d& normal, const Eigen::Vector3d& mass) {
  StablePose pose;
  pose.R = Eigen::Quaterniond::FromTwoVectors(normal, -Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& v : mesh.vertices)
    pose.lowest = std::min(pose.lowest, (pose.R * v).z());
  std::vector<Eigen::Vector2d> support;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    const Eigen::Vector3d x = pose.R * v;
    if (x.z() < pose.lowest + 2 * kCoplanar_mm) support.push_back(x.head<2>());
  }
  const Eigen::Vector3d above = pose.R * mass;
  const double inside = depth_inside(convex_hull(support), above.head<2>());
  pose.steadiness = std::atan2(inside, above.z() - pose.lowest);
  return pose;
}

}  // namespace

Eigen::Vector3d centre_of_mass(const Mesh& mesh) {
  // Sum over the tetrahedra from the first vertex, which keeps the numbers small.
  const Eigen::Vector3d origin = mesh.vertices.at(0);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double volume = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[0]] - origin, b = mesh.vertices[t[1]] - origin,
                          c = mesh.vertices[t[2]] - origin;
    const double v = a.dot(b.cross(c));
    volume += v;
    moment += v * (a + b + c) / 4;
  }
  return origin + moment / volume;
}

std::vector<StablePose> stable_poses(const Mesh& mesh, double steadiness) {
  const std::vector<Eigen::Vector3d>& v = mesh.vertices;
  const Eigen::Vector3d mass = centre_of_mass(mesh);
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      for (std::size_t k = j + 1; k < v.size(); ++k) {
        const auto n = support_normal(v, i, j, k);
        if (!n) continue;
        const bool known = std::any_of(normals.begin(), normals.end(), [&](const auto& m) {
          return (m - *n).norm() < kSameDirection;
        });
        if (!known) normals.push_back(*n);
      }
  std::vector<StablePose> poses;
  for (const Eigen::Vector3d& n : normals) {
    const StablePose pose = pose_on(mesh, n, mass);
    if (pose.steadiness >= steadiness) poses.push_back(pose);
  }
  return poses;
}

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  if (points.size() < 3) return points;
  // Monotone chain: the lower border left to right, then the upper one back.
  std::vector<Eigen::Vector2d> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= start + 2 &&
             cross2(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double depth_inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  if (polygon.size() < 3) return -std::numeric_limits<double>::infinity();
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    depth = std::min(depth, cross2((b - a).normalized(), p - a));
  }
  return depth;
}

}  // namespace trihedron::render
