// SPDX-License-Identifier: Apache-2.0
#include "recognition/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trihedron {
namespace {

/// Both ways of every edge, one of those that a symmetry maps onto each other.
void append_edges(const Model& model, int index, std::vector<DirectedEdge>& out) {
  const std::size_t begin = out.size();
  const double same_position = 1e-3 * model.diameter;
  const auto vertex = [&](int v) { return model.mesh.vertices[static_cast<std::size_t>(v)]; };
  const auto equal = [&](const DirectedEdge& a, const DirectedEdge& b) {
    return std::any_of(model.symmetries.begin(), model.symmetries.end(), [&](const Transform& s) {
      return (s * vertex(a.from) - vertex(b.from)).norm() < same_position &&
             (s * vertex(a.to) - vertex(b.to)).norm() < same_position;
    });
  };
  for (int e = 0; e < static_cast<int>(model.edges.size()); ++e) {
    const ModelEdge& edge = model.edges[static_cast<std::size_t>(e)];
    for (const bool back : {false, true}) {
      const DirectedEdge d{index, e, back ? edge.v1 : edge.v0, back ? edge.v0 : edge.v1,
                           edge.length};
      const auto from = out.begin() + static_cast<std::ptrdiff_t>(begin);
      if (std::none_of(from, out.end(), [&](const auto& other) { return equal(d, other); })) {
        out.push_back(d);
      }
    }
  }
}

ModelSketch sketch_of(const Model& model) {
  ModelSketch out;
  out.diameter = model.diameter;
  out.vertex_mean.setZero();
  for (const Eigen::Vector3d& x : model.mesh.vertices) out.vertex_mean += x;
  out.vertex_mean /= static_cast<double>(model.mesh.vertices.size());
  for (const Eigen::Vector3d& x : model.mesh.vertices) out.vertices.push_back(x.cast<float>());
  for (const Surface& surface : model.surfaces) {
    out.surfaces.push_back({surface.normal.cast<float>(), static_cast<float>(surface.offset)});
  }
  for (std::size_t i = 0; i < model.edges.size(); ++i) {
    const ModelEdge& e = model.edges[i];
    out.edges.push_back(
        {e.v0, e.v1, e.left, e.right, static_cast<int>(i), static_cast<float>(e.length)});
  }
  std::stable_sort(out.edges.begin(), out.edges.end(),
                   [](const auto& a, const auto& b) { return a.length > b.length; });
  return out;
}

/// The entries of a sorted list whose key lies in [low, high].
template <typename T>
LibraryIndex::Range<T> range(const std::vector<T>& sorted, double T::*key, double low,
                             double high) {
  const auto first = std::lower_bound(sorted.begin(), sorted.end(), low,
                                      [&](const T& x, double v) { return x.*key < v; });
  const auto last =
      std::upper_bound(first, sorted.end(), high, [&](double v, const T& x) { return v < x.*key; });
  return {sorted.data() + (first - sorted.begin()), sorted.data() + (last - sorted.begin())};
}

template <typename T>
void sort_by(std::vector<T>& list, double T::*key) {
  std::stable_sort(list.begin(), list.end(),
                   [&](const T& a, const T& b) { return a.*key < b.*key; });
}

}  // namespace

std::pair<const ModelSketch::Edge*, const ModelSketch::Edge*> ModelSketch::edges_by_length(
    double low, double high) const {
  const auto first =
      std::lower_bound(edges.begin(), edges.end(), high,
                       [](const Edge& e, double length) { return e.length > length; });
  const auto last = std::upper_bound(
      first, edges.end(), low, [](double length, const Edge& e) { return length > e.length; });
  return {edges.data() + (first - edges.begin()), edges.data() + (last - edges.begin())};
}

float ModelSketch::lowest(const Transform& world_from_model) const {
  const Eigen::Vector3f up = world_from_model.R.row(2).transpose().cast<float>();
  float least = std::numeric_limits<float>::max();
  for (const Eigen::Vector3f& x : vertices) least = std::min(least, up.dot(x));
  return least + static_cast<float>(world_from_model.t.z());
}

LibraryIndex::LibraryIndex(const std::vector<Model>& library) : corners_(library) {
  for (std::size_t i = 0; i < library.size(); ++i) {
    sketches_.push_back(sketch_of(library[i]));
    append_edges(library[i], static_cast<int>(i), edges_);
  }
  sort_by(edges_, &DirectedEdge::length);
}

LibraryIndex::Range<DirectedEdge> LibraryIndex::edges_by_length(double low, double high) const {
  return range(edges_, &DirectedEdge::length, low, high);
}

}  // namespace trihedron
