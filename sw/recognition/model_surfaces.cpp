// SPDX-License-Identifier: Apache-2.0
#include "recognition/model_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "golden/error.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// More planar faces than this are a curved part: the method needs faces of many pixels.
constexpr int kMaxSurfaces = 256;
/// So many faces that each meet two neighbours at less than kSmoothRad are a curved part too
/// (a finely cut cylinder): its bends show too little contrast to become contours.
constexpr int kMaxSmoothSurfaces = 96;
constexpr double kSmoothRad = 15 * 3.14159265358979 / 180;

struct Plane {
  Vector3d normal;
  double offset;
};

Vector3d cross_of(const Mesh& mesh, int triangle) {
  const auto& t = mesh.triangles[triangle];
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]])
      .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

/// Whether the triangle lies in the plane. The direction is asked only of triangles wider than
/// the tolerance: a sliver's normal is noise.
bool lies_in(const Topology& topology, int triangle, const Vector3d& cross, const Plane& plane) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * triangle + k;
    const Vector3d& x = topology.mesh.vertices[topology.origin(h)];
    if (std::abs(plane.normal.dot(x) - plane.offset) > topology.tolerance) return false;
    longest = std::max(longest, (topology.mesh.vertices[topology.target(h)] - x).norm());
  }
  const bool sliver = cross.norm() < longest * topology.tolerance;
  constexpr double kSameSide = 0.5;
  return sliver || cross.dot(plane.normal) > kSameSide * cross.norm();
}

void grow(const Topology& topology, const std::vector<Vector3d>& cross, int seed, int id,
          std::vector<int>& surface_of) {
  const Vector3d normal = cross[seed].normalized();
  const Plane plane{normal, normal.dot(topology.mesh.vertices[topology.origin(3 * seed)])};
  std::vector<int> open = {seed};
  surface_of[seed] = id;
  while (!open.empty()) {
    const int triangle = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k) {
      const int other = topology.twin[3 * triangle + k] / 3;
      if (surface_of[other] >= 0 || !lies_in(topology, other, cross[other], plane)) continue;
      surface_of[other] = id;
      open.push_back(other);
    }
  }
}

/// Surfaces with at least two smooth neighbours.
int count_smooth(const Topology& topology, const std::vector<int>& surface_of,
                 const std::vector<Vector3d>& normals) {
  std::vector<std::vector<int>> smooth(normals.size());
  for (std::size_t h = 0; h < topology.twin.size(); ++h) {
    const int a = surface_of[h / 3], b = surface_of[topology.twin[h] / 3];
    if (a == b || normals[a].dot(normals[b]) < std::cos(kSmoothRad)) continue;
    if (std::find(smooth[a].begin(), smooth[a].end(), b) == smooth[a].end()) smooth[a].push_back(b);
  }
  return static_cast<int>(
      std::count_if(smooth.begin(), smooth.end(), [](const auto& s) { return s.size() >= 2; }));
}

void check_not_curved(const std::string& name, const Topology& topology,
                      const std::vector<int>& surface_of, const std::vector<Vector3d>& normals) {
  const int surfaces = static_cast<int>(normals.size());
  const int smooth = count_smooth(topology, surface_of, normals);
  if (surfaces <= kMaxSurfaces && smooth <= kMaxSmoothSurfaces) return;
  throw Error(name + ": the part is curved (" + std::to_string(surfaces) + " planar faces, " +
              std::to_string(smooth) + " of them in smooth bends) and lies outside the method; " +
              "expected a polyhedron of at most " + std::to_string(kMaxSurfaces) + " faces");
}

bool is_border(const Topology& topology, const std::vector<int>& surface_of, int h) {
  return surface_of[h / 3] != surface_of[topology.twin[h] / 3];
}

/// The border half edge that follows border half edge h around the same surface.
int next_border(const Topology& topology, const std::vector<int>& surface_of, int h) {
  h = Topology::next(h);
  while (!is_border(topology, surface_of, h)) h = Topology::next(topology.twin[h]);
  return h;
}

/// Whether a vertex is a corner of the model: not inside a surface and not on a straight edge.
std::vector<char> find_corners(const Topology& topology, const std::vector<int>& surface_of) {
  const auto& x = topology.mesh.vertices;
  std::vector<std::vector<int>> borders(x.size());  // per vertex: the border edges' other ends
  for (std::size_t h = 0; h < topology.twin.size(); ++h)
    if (is_border(topology, surface_of, static_cast<int>(h)))
      borders[topology.origin(static_cast<int>(h))].push_back(topology.target(static_cast<int>(h)));
  std::vector<char> corner(x.size(), 0);
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (borders[v].size() != 2) {
      corner[v] = borders[v].size() > 2;
      continue;
    }
    const Vector3d& a = x[borders[v][0]];
    const Vector3d& b = x[borders[v][1]];
    const Vector3d along = (b - a).normalized();
    const bool straight =
        (x[v] - a).cross(along).norm() <= topology.tolerance && (x[v] - a).dot(b - x[v]) > 0;
    corner[v] = !straight;
  }
  return corner;
}

}  // namespace

Vector3d area_vector2(const std::vector<Vector3d>& vertices, const std::vector<int>& loop) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (vertices[loop[i]] - vertices[loop[0]])
               .cross(vertices[loop[(i + 1) % loop.size()]] - vertices[loop[0]]);
  return sum;
}

std::vector<int> merge_coplanar(const std::string& name, const Topology& topology) {
  const int count = static_cast<int>(topology.mesh.triangles.size());
  std::vector<Vector3d> cross(count);
  std::vector<int> order(count), grown(count, -1);
  for (int i = 0; i < count; ++i) cross[i] = cross_of(topology.mesh, i);
  // Large triangles first: their planes are the surest.
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return cross[a].squaredNorm() > cross[b].squaredNorm(); });
  int id = 0;
  for (int seed : order)
    if (grown[seed] < 0) grow(topology, cross, seed, id++, grown);

  std::vector<int> renamed(id, -1), surface_of(count);
  std::vector<Vector3d> normals;
  for (int i = 0; i < count; ++i) {
    int& to = renamed[grown[i]];
    if (to < 0) {
      to = static_cast<int>(normals.size());
      normals.push_back(Vector3d::Zero());
    }
    surface_of[i] = to;
    normals[to] += cross[i];
  }
  for (Vector3d& n : normals) n.normalize();
  check_not_curved(name, topology, surface_of, normals);
  return surface_of;
}

std::vector<std::vector<std::vector<int>>> surface_loops(const std::string& name,
                                                         const Topology& topology,
                                                         const std::vector<int>& surface_of) {
  const std::vector<char> corner = find_corners(topology, surface_of);
  std::vector<std::vector<std::vector<int>>> loops(
      1 + *std::max_element(surface_of.begin(), surface_of.end()));
  std::vector<char> seen(topology.twin.size(), 0);
  for (int start = 0; start < static_cast<int>(seen.size()); ++start) {
    if (seen[start] || !is_border(topology, surface_of, start)) continue;
    std::vector<int> loop;
    int h = start;
    do {
      seen[h] = 1;
      if (corner[topology.origin(h)]) loop.push_back(topology.origin(h));
      h = next_border(topology, surface_of, h);
    } while (h != start);
    if (loop.size() >= 3) loops[surface_of[start / 3]].push_back(loop);
  }
  const auto& x = topology.mesh.vertices;
  for (auto& of_surface : loops) {
    if (of_surface.empty())
      throw Error(name + ": a planar face is thinner than " + std::to_string(topology.tolerance) +
                  " mm; expected faces that a camera can see");
    std::stable_sort(of_surface.begin(), of_surface.end(), [&](const auto& a, const auto& b) {
      return area_vector2(x, a).squaredNorm() > area_vector2(x, b).squaredNorm();
    });
  }
  return loops;
}

}  // namespace trihedron
