// SPDX-License-Identifier: Apache-2.0
#include "recognition/index.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

ModelCorner make_corner(const Model& model, int index, int vertex, int first, int second) {
  const auto leave = [&](int edge) -> Eigen::Vector3d {
    const ModelEdge& e = model.edges[static_cast<std::size_t>(edge)];
    const int other = e.v0 == vertex ? e.v1 : e.v0;
    return (model.mesh.vertices[static_cast<std::size_t>(other)] -
            model.mesh.vertices[static_cast<std::size_t>(vertex)])
        .normalized();
  };
  ModelCorner c;
  c.model = index;
  c.vertex = vertex;
  c.position = model.mesh.vertices[static_cast<std::size_t>(vertex)];
  c.along = leave(first);
  c.aside = leave(second);
  c.length = model.edges[static_cast<std::size_t>(first)].length;
  c.aside_length = model.edges[static_cast<std::size_t>(second)].length;
  c.angle = std::acos(std::clamp(c.along.dot(c.aside), -1.0, 1.0));
  const auto normals = [&](int edge) -> std::array<Eigen::Vector3d, 2> {
    const ModelEdge& e = model.edges[static_cast<std::size_t>(edge)];
    return {model.surfaces[static_cast<std::size_t>(e.left)].normal,
            model.surfaces[static_cast<std::size_t>(e.right)].normal};
  };
  c.along_normals = normals(first);
  c.aside_normals = normals(second);
  return c;
}

/// Whether a symmetry maps a onto b.
bool equivalent(const Model& model, const ModelCorner& a, const ModelCorner& b) {
  constexpr double kSameDirection = 1e-3;
  const double same_position = 1e-3 * model.diameter;
  return std::any_of(model.symmetries.begin(), model.symmetries.end(), [&](const Transform& s) {
    return (s * a.position - b.position).norm() < same_position &&
           (s.R * a.along - b.along).norm() < kSameDirection &&
           (s.R * a.aside - b.aside).norm() < kSameDirection;
  });
}

void append_corners(const Model& model, int index, std::vector<ModelCorner>& out) {
  const std::size_t begin = out.size();
  for (int v = 0; v < static_cast<int>(model.vertex_edges.size()); ++v) {
    const std::vector<int>& edges = model.vertex_edges[static_cast<std::size_t>(v)];
    for (const int first : edges) {
      for (const int second : edges) {
        if (first == second) continue;
        const ModelCorner c = make_corner(model, index, v, first, second);
        const auto from = out.begin() + static_cast<std::ptrdiff_t>(begin);
        const bool known = std::any_of(
            from, out.end(), [&](const ModelCorner& other) { return equivalent(model, c, other); });
        if (!known) out.push_back(c);
      }
    }
  }
}

}  // namespace

LibraryIndex::LibraryIndex(const std::vector<Model>& library) {
  for (std::size_t i = 0; i < library.size(); ++i) {
    append_corners(library[i], static_cast<int>(i), by_length_);
  }
  by_angle_ = by_length_;
  std::stable_sort(by_length_.begin(), by_length_.end(),
                   [](const auto& a, const auto& b) { return a.length < b.length; });
  std::stable_sort(by_angle_.begin(), by_angle_.end(),
                   [](const auto& a, const auto& b) { return a.angle < b.angle; });
}

LibraryIndex::Range LibraryIndex::by_length(double low, double high) const {
  const auto first = std::lower_bound(by_length_.begin(), by_length_.end(), low,
                                      [](const auto& c, double v) { return c.length < v; });
  const auto last = std::upper_bound(first, by_length_.end(), high,
                                     [](double v, const auto& c) { return v < c.length; });
  return {by_length_.data() + (first - by_length_.begin()),
          by_length_.data() + (last - by_length_.begin())};
}

LibraryIndex::Range LibraryIndex::by_angle(double low, double high) const {
  const auto first = std::lower_bound(by_angle_.begin(), by_angle_.end(), low,
                                      [](const auto& c, double v) { return c.angle < v; });
  const auto last = std::upper_bound(first, by_angle_.end(), high,
                                     [](double v, const auto& c) { return v < c.angle; });
  return {by_angle_.data() + (first - by_angle_.begin()),
          by_angle_.data() + (last - by_angle_.begin())};
}

}  // namespace trihedron
