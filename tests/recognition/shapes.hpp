// SPDX-License-Identifier: Apache-2.0
// Meshes made for tests, mm.
#pragma once

#include <vector>

#include "recognition/model.hpp"

namespace trihedron::shapes {

/// The prism over a counter-clockwise polygon (x, y), from z = 0 to `height`, its caps cut into
/// fans: the polygon must be star shaped from its first corner.
inline Mesh prism(const std::vector<Eigen::Vector2d>& polygon, double height) {
  Mesh mesh;
  const int n = static_cast<int>(polygon.size());
  for (const auto& p : polygon) mesh.vertices.emplace_back(p.x(), p.y(), 0);
  for (const auto& p : polygon) mesh.vertices.emplace_back(p.x(), p.y(), height);
  for (int i = 2; i < n; ++i) {
    mesh.triangles.push_back({0, i, i - 1});
    mesh.triangles.push_back({n, n + i - 1, n + i});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
  }
  return mesh;
}

inline Mesh block(double x, double y, double z) {
  return prism({{0, 0}, {x, 0}, {x, y}, {0, y}}, z);
}

/// A regular prism of n sides and the given radius.
inline Mesh regular_prism(int n, double radius, double height) {
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return prism(polygon, height);
}

/// A plate of outer size a with a square hole of size b through it.
inline Mesh frame(double a, double b, double height) {
  Mesh mesh;
  for (double z : {0.0, height})
    for (double r : {a / 2, b / 2})
      for (int k = 0; k < 4; ++k)
        mesh.vertices.emplace_back(k == 0 || k == 3 ? -r : r, k < 2 ? -r : r, z);
  for (int k = 0; k < 4; ++k) {
    const int j = (k + 1) % 4;
    const auto quad = [&](int p, int q, int r, int s) {
      mesh.triangles.push_back({p, q, r});
      mesh.triangles.push_back({p, r, s});
    };
    quad(k, 4 + k, 4 + j, j);            // bottom ring
    quad(8 + k, 8 + j, 12 + j, 12 + k);  // top ring
    quad(k, j, 8 + j, 8 + k);            // outer wall
    quad(4 + k, 12 + k, 12 + j, 4 + j);  // inner wall
  }
  return mesh;
}

/// Each triangle cut into four through its edges' middles.
inline Mesh subdivided(const Mesh& mesh) {
  Mesh out;
  for (const auto& t : mesh.triangles) {
    const int base = static_cast<int>(out.vertices.size());
    for (int k = 0; k < 3; ++k) out.vertices.push_back(mesh.vertices[t[k]]);
    for (int k = 0; k < 3; ++k)
      out.vertices.push_back((mesh.vertices[t[k]] + mesh.vertices[t[(k + 1) % 3]]) / 2);
    out.triangles.push_back({base, base + 3, base + 5});
    out.triangles.push_back({base + 3, base + 1, base + 4});
    out.triangles.push_back({base + 5, base + 4, base + 2});
    out.triangles.push_back({base + 3, base + 4, base + 5});
  }
  return out;
}

/// A block of 60 x 50 x 40 mm with one upper corner cut off, at other distances along each edge:
/// no two of the corner's eight places on a block are alike.
inline Mesh cut_block() {
  Mesh mesh = block(60, 50, 40);
  mesh.vertices[6] = {60, 50, 28};
  mesh.vertices.emplace_back(48, 50, 40);
  mesh.vertices.emplace_back(60, 32, 40);
  mesh.triangles.clear();
  const std::vector<std::vector<int>> surfaces = {{0, 3, 2, 1},    {4, 5, 9, 8, 7}, {0, 1, 5, 4},
                                                  {1, 2, 6, 9, 5}, {3, 7, 8, 6, 2}, {0, 4, 7, 3},
                                                  {6, 8, 9}};
  for (const std::vector<int>& corners : surfaces)
    for (std::size_t i = 2; i < corners.size(); ++i)
      mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  return mesh;
}

}  // namespace trihedron::shapes
