// SPDX-License-Identifier: Apache-2.0
#include "recognition/model_topology.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>

#include "golden/error.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// CAD writes single precision or four decimals: positions of one mesh agree to this part of
/// its size.
constexpr double kRelativeTolerance = 1e-4;
constexpr double kSmallestMm = 1, kLargestMm = 5000;

std::string text(const Vector3d& x) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "(%.6g, %.6g, %.6g)", x.x(), x.y(), x.z());
  return buffer;
}

std::string edge_text(const Mesh& mesh, int a, int b) {
  return "the edge from " + text(mesh.vertices[a]) + " to " + text(mesh.vertices[b]);
}

void check_numbers(const std::string& name, const Mesh& mesh) {
  if (mesh.vertices.empty() || mesh.triangles.empty())
    throw Error(name + ": the mesh is empty; expected a closed polyhedron of triangles");
  for (const Vector3d& x : mesh.vertices)
    if (!x.allFinite()) throw Error(name + ": a vertex is not a finite number; expected mm");
  const int count = static_cast<int>(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int v : mesh.triangles[i])
      if (v < 0 || v >= count)
        throw Error(name + ": triangle " + std::to_string(i) + " uses vertex " + std::to_string(v) +
                    "; expected 0 to " + std::to_string(count - 1));
}

double box_diagonal(const Mesh& mesh) {
  Vector3d low = mesh.vertices[0], high = low;
  for (const Vector3d& x : mesh.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

void check_size(const std::string& name, double diagonal) {
  if (diagonal >= kSmallestMm && diagonal <= kLargestMm) return;
  char buffer[160];
  std::snprintf(buffer, sizeof buffer,
                ": the mesh is %.6g mm across; expected %g to %g mm (is its unit the mm?)",
                diagonal, kSmallestMm, kLargestMm);
  throw Error(name + buffer);
}

using Cell = std::array<std::int64_t, 3>;

/// Index of the first vertex within `tolerance` of each vertex.
std::vector<int> weld(const std::vector<Vector3d>& vertices, double tolerance) {
  std::map<Cell, std::vector<int>> grid;  // cells of the tolerance's size: neighbours touch
  std::vector<int> first(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Cell cell;
    for (int k = 0; k < 3; ++k) cell[k] = std::llround(std::floor(vertices[i][k] / tolerance));
    int found = static_cast<int>(i);
    for (int n = 0; n < 27; ++n) {
      const auto near =
          grid.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (near == grid.end()) continue;
      for (int j : near->second)
        if ((vertices[i] - vertices[j]).norm() <= tolerance) found = std::min(found, j);
    }
    first[i] = found;
    if (found == static_cast<int>(i)) grid[cell].push_back(found);
  }
  return first;
}

/// The mesh on welded vertices, without vertices that no triangle uses and without triangles
/// that welding has closed.
Mesh welded(const Mesh& mesh, double tolerance) {
  const std::vector<int> first = weld(mesh.vertices, tolerance);
  std::vector<int> used(mesh.vertices.size(), 0), index(mesh.vertices.size(), -1);
  Mesh out;
  for (const auto& t : mesh.triangles) {
    const std::array<int, 3> w = {first[t[0]], first[t[1]], first[t[2]]};
    if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) continue;
    out.triangles.push_back(w);
    for (int v : w) used[v] = 1;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    index[v] = static_cast<int>(out.vertices.size());
    out.vertices.push_back(mesh.vertices[v]);
  }
  for (auto& t : out.triangles)
    for (int& v : t) v = index[v];
  return out;
}

/// The two triangles at each undirected edge. Throws where there are not exactly two.
std::map<std::pair<int, int>, std::vector<int>> edge_triangles(const std::string& name,
                                                               const Mesh& mesh) {
  std::map<std::pair<int, int>, std::vector<int>> at;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
      at[std::minmax(a, b)].push_back(static_cast<int>(i));
    }
  for (const auto& [edge, triangles] : at) {
    if (triangles.size() == 2) continue;
    throw Error(name + ": " + (triangles.size() == 1 ? "not closed: " : "not manifold: ") +
                edge_text(mesh, edge.first, edge.second) + " belongs to " +
                std::to_string(triangles.size()) +
                (triangles.size() == 1 ? " triangle" : " triangles") +
                "; in a closed polyhedron every edge belongs to 2");
  }
  return at;
}

bool runs(const std::array<int, 3>& t, int a, int b) {
  for (int k = 0; k < 3; ++k)
    if (t[k] == a && t[(k + 1) % 3] == b) return true;
  return false;
}

/// Six times the signed volume.
double volume6(const Mesh& mesh, const std::vector<int>& triangles) {
  double sum = 0;
  for (int i : triangles) {
    const auto& t = mesh.triangles[i];
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  }
  return sum;
}

/// Turns the triangles of one connected piece, started at `seed`, to the seed's orientation.
/// Returns the piece and whether any had to be turned.
std::pair<std::vector<int>, bool> align_piece(
    const std::string& name, const std::map<std::pair<int, int>, std::vector<int>>& at, int seed,
    std::vector<char>& seen, Mesh& mesh) {
  std::vector<int> piece = {seed};
  bool turned = false;
  seen[seed] = 1;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::array<int, 3> t = mesh.triangles[piece[i]];
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const auto& pair = at.at(std::minmax(a, b));
      const int other = pair[0] == piece[i] ? pair[1] : pair[0];
      const bool agrees = runs(mesh.triangles[other], b, a);
      if (!agrees && seen[other])
        throw Error(name + ": " + edge_text(mesh, a, b) +
                    " joins triangles that cannot be turned to one side; expected a surface with "
                    "an inside and an outside");
      if (!agrees) {
        std::swap(mesh.triangles[other][1], mesh.triangles[other][2]);
        turned = true;
      }
      if (!seen[other]) {
        seen[other] = 1;
        piece.push_back(other);
      }
    }
  }
  return {piece, turned};
}

void flip(Mesh& mesh, const std::vector<int>& triangles) {
  for (int i : triangles) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
}

/// Turns all triangles outwards. A piece that was consistent keeps its sign against the others
/// (a cavity points inwards on purpose); one that had to be mended is taken as a solid.
void orient(const std::string& name, const std::map<std::pair<int, int>, std::vector<int>>& at,
            double diagonal, Mesh& mesh) {
  std::vector<char> seen(mesh.triangles.size(), 0);
  std::vector<int> all;
  for (std::size_t seed = 0; seed < seen.size(); ++seed) {
    if (seen[seed]) continue;
    const auto [piece, turned] = align_piece(name, at, static_cast<int>(seed), seen, mesh);
    if (turned && volume6(mesh, piece) < 0) flip(mesh, piece);
    all.insert(all.end(), piece.begin(), piece.end());
  }
  const double volume = volume6(mesh, all) / 6;
  const double thinnest = kRelativeTolerance * diagonal;  // a needle of this width still counts
  if (std::abs(volume) < thinnest * thinnest * diagonal)
    throw Error(name + ": the mesh encloses no volume; expected a solid");
  if (volume < 0) flip(mesh, all);
}

}  // namespace

Topology build_topology(const std::string& name, const Mesh& mesh) {
  check_numbers(name, mesh);
  const double diagonal = box_diagonal(mesh);
  check_size(name, diagonal);
  Topology out;
  out.tolerance = kRelativeTolerance * diagonal;
  // Welding is a tenth of the tolerance: small features must survive it.
  out.mesh = welded(mesh, out.tolerance / 10);
  if (out.mesh.triangles.empty())
    throw Error(name + ": all triangles are points or lines; expected a closed polyhedron");
  const auto at = edge_triangles(name, out.mesh);
  orient(name, at, diagonal, out.mesh);

  std::map<std::pair<int, int>, int> half_edge;
  const int count = 3 * static_cast<int>(out.mesh.triangles.size());
  for (int h = 0; h < count; ++h) half_edge[{out.origin(h), out.target(h)}] = h;
  for (int h = 0; h < count; ++h) out.twin.push_back(half_edge.at({out.target(h), out.origin(h)}));
  return out;
}

}  // namespace trihedron
