// SPDX-License-Identifier: Apache-2.0
#include "recognition/model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "golden/error.hpp"
#include "recognition/model_surfaces.hpp"
#include "recognition/model_topology.hpp"
#include "recognition/symmetry.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;
using Loops = std::vector<std::vector<int>>;

/// The vertices that the loops use, renumbered in their old order.
std::vector<Vector3d> compact(const std::vector<Vector3d>& vertices, std::vector<Loops>& loops) {
  std::vector<int> index(vertices.size(), -1);
  for (const Loops& of_surface : loops)
    for (const auto& loop : of_surface)
      for (int v : loop) index[v] = 0;
  std::vector<Vector3d> out;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (index[v] < 0) continue;
    index[v] = static_cast<int>(out.size());
    out.push_back(vertices[v]);
  }
  for (Loops& of_surface : loops)
    for (auto& loop : of_surface)
      for (int& v : loop) v = index[v];
  return out;
}

double perimeter_of(const std::vector<Vector3d>& x, const Loops& loops) {
  double sum = 0;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += (x[loop[(i + 1) % loop.size()]] - x[loop[i]]).norm();
  return sum;
}

/// A surface from its boundaries; its triangles are added to the mesh.
Surface make_surface(const Loops& loops, Mesh& mesh) {
  Surface surface;
  surface.loops = loops;
  Vector3d sum = Vector3d::Zero();
  for (const auto& loop : loops) sum += area_vector2(mesh.vertices, loop);
  surface.normal = sum.normalized();
  surface.area = sum.norm() / 2;
  surface.perimeter = perimeter_of(mesh.vertices, loops);

  double weight = 0;
  Vector3d moment = Vector3d::Zero();
  for (const auto& t : triangulate(mesh.vertices, loops, surface.normal)) {
    const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double area = (b - a).cross(c - a).norm() / 2;
    weight += area;
    moment += area * (a + b + c) / 3;
    surface.triangles.push_back(static_cast<int>(mesh.triangles.size()));
    mesh.triangles.push_back(t);
  }
  surface.centroid = moment / weight;
  surface.offset = surface.normal.dot(surface.centroid);
  return surface;
}

/// The edges between surfaces, each once, in the order in which the surfaces' loops name them.
std::vector<ModelEdge> find_edges(const std::string& name, const Model& model) {
  std::map<std::pair<int, int>, std::vector<int>> surfaces_at;  // directed edge -> left surfaces
  const int count = static_cast<int>(model.surfaces.size());
  for (int s = 0; s < count; ++s)
    for (const auto& loop : model.surfaces[s].loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        surfaces_at[{loop[i], loop[(i + 1) % loop.size()]}].push_back(s);

  std::vector<ModelEdge> edges;
  for (int s = 0; s < count; ++s)
    for (const auto& loop : model.surfaces[s].loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int v0 = loop[i], v1 = loop[(i + 1) % loop.size()];
        const auto back = surfaces_at.find({v1, v0});
        if (back == surfaces_at.end() || back->second.size() != 1)
          throw Error(name + ": two faces do not share the edge between their corners; expected " +
                      "flat faces (largest deviation 1/10000 of the size)");
        const int other = back->second[0];
        if (other < s) continue;
        const Vector3d along = model.mesh.vertices[v1] - model.mesh.vertices[v0];
        const Vector3d turn = model.surfaces[s].normal.cross(model.surfaces[other].normal);
        edges.push_back({v0, v1, s, other, along.norm(), turn.dot(along) > 0});
      }
  return edges;
}

double largest_distance(const std::vector<Vector3d>& x) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) largest = std::max(largest, (x[i] - x[j]).squaredNorm());
  return std::sqrt(largest);
}

}  // namespace

Model build_model(int id, const std::string& name, const Mesh& mesh) {
  const Topology topology = build_topology(name, mesh);
  std::vector<Loops> loops = surface_loops(name, topology, merge_coplanar(name, topology));
  Model model;
  model.id = id;
  model.name = name;
  model.mesh.vertices = compact(topology.mesh.vertices, loops);
  for (const Loops& of_surface : loops)
    model.surfaces.push_back(make_surface(of_surface, model.mesh));
  model.edges = find_edges(name, model);
  model.vertex_edges.resize(model.mesh.vertices.size());
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    model.vertex_edges[model.edges[e].v0].push_back(static_cast<int>(e));
    model.vertex_edges[model.edges[e].v1].push_back(static_cast<int>(e));
  }
  model.diameter = largest_distance(model.mesh.vertices);
  for (const Transform& motion : congruences(model, model))
    if (!is_identity(motion, model)) model.symmetries.push_back(motion);
  return model;
}

}  // namespace trihedron
