// SPDX-License-Identifier: Apache-2.0
#include "recognition/corner_index.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Directions that differ by less are one: a thousandth of a radian, 0.1 px at the end of an edge
/// of 100 px. Below the sine, the edges span no plane.
constexpr double kSame = 1e-3;

struct Corner {
  ModelCorner corner;
  CornerLengths lengths;
  Vector3d along, aside;  // unit, model frame
  CornerShape shape;
};

/// A direction in steps of kSame.
std::array<long, 3> steps_of(const Vector3d& v) {
  return {std::lround(v.x() / kSame), std::lround(v.y() / kSame), std::lround(v.z() / kSame)};
}

Vector3d leaving(const Model& model, int vertex, int edge) {
  const ModelEdge& e = model.edges[static_cast<std::size_t>(edge)];
  const int other = e.v0 == vertex ? e.v1 : e.v0;
  return (model.mesh.vertices[static_cast<std::size_t>(other)] -
          model.mesh.vertices[static_cast<std::size_t>(vertex)])
      .normalized();
}

/// The longest edge at the vertex but for two; -1 where there is none.
int longest_other(const Model& model, int vertex, int first, int second) {
  int found = -1;
  for (const int e : model.vertex_edges[static_cast<std::size_t>(vertex)]) {
    if (e == first || e == second) continue;
    const auto length = [&](int i) { return model.edges[static_cast<std::size_t>(i)].length; };
    if (found < 0 || length(e) > length(found)) found = e;
  }
  return found;
}

/// False where the two edges lie on one line.
bool make_corner(const Model& model, int index, int vertex, int first, int second, Corner& out) {
  out.along = leaving(model, vertex, first);
  out.aside = leaving(model, vertex, second);
  CornerShape& shape = out.shape;
  shape.cosine = std::clamp(out.along.dot(out.aside), -1.0, 1.0);
  shape.sine = std::sqrt(1 - shape.cosine * shape.cosine);
  const int third = longest_other(model, vertex, first, second);
  if (shape.sine < kSame || third < 0) return false;
  const Vector3d side = (out.aside - shape.cosine * out.along) / shape.sine;
  Matrix3d frame;
  frame << out.along, side, out.along.cross(side);
  out.corner = {index, model.mesh.vertices[static_cast<std::size_t>(vertex)], frame};
  shape.third = frame.transpose() * leaving(model, vertex, third);
  const int edges[3] = {first, second, third};
  float* lengths[3] = {&out.lengths.first, &out.lengths.second, &out.lengths.third};
  for (std::size_t k = 0; k < 3; ++k) {
    const ModelEdge& e = model.edges[static_cast<std::size_t>(edges[k])];
    *lengths[k] = static_cast<float>(e.length);
    const Vector3d left =
        frame.transpose() * model.surfaces[static_cast<std::size_t>(e.left)].normal;
    const Vector3d right =
        frame.transpose() * model.surfaces[static_cast<std::size_t>(e.right)].normal;
    shape.normals[k] = {left, right};
    // Which one is left depends on the way the edge is stored, not on the shape.
    if (steps_of(right) < steps_of(left)) std::swap(shape.normals[k][0], shape.normals[k][1]);
  }
  return true;
}

/// Whether a symmetry maps a onto b.
bool equivalent(const Model& model, const Corner& a, const Corner& b) {
  const double same_position = kSame * model.diameter;
  return std::any_of(model.symmetries.begin(), model.symmetries.end(), [&](const Transform& s) {
    return (s * a.corner.position - b.corner.position).norm() < same_position &&
           (s.R * a.along - b.along).norm() < kSame && (s.R * a.aside - b.aside).norm() < kSame;
  });
}

std::vector<Corner> corners_of(const Model& model, int index) {
  std::vector<Corner> out;
  for (int v = 0; v < static_cast<int>(model.vertex_edges.size()); ++v) {
    const std::vector<int>& edges = model.vertex_edges[static_cast<std::size_t>(v)];
    for (const int first : edges) {
      for (const int second : edges) {
        Corner c;
        if (first == second || !make_corner(model, index, v, first, second, c)) continue;
        const bool known = std::any_of(out.begin(), out.end(), [&](const Corner& other) {
          return equivalent(model, c, other);
        });
        if (!known) out.push_back(c);
      }
    }
  }
  return out;
}

/// Equal for corners of one shape.
using Key = std::array<long, 22>;

Key key_of(const CornerShape& shape) {
  Key key{};
  auto at = key.begin();
  *at++ = std::lround(shape.cosine / kSame);
  const auto put = [&](const Vector3d& v) {
    for (const long step : steps_of(v)) *at++ = step;
  };
  put(shape.third);
  for (const auto& surfaces : shape.normals) {
    for (const Vector3d& normal : surfaces) put(normal);
  }
  return key;
}

}  // namespace

CornerIndex::CornerIndex(const std::vector<Model>& library) {
  std::map<Key, std::vector<Corner>> corners_by_shape;
  for (std::size_t i = 0; i < library.size(); ++i) {
    for (const Corner& c : corners_of(library[i], static_cast<int>(i))) {
      corners_by_shape[key_of(c.shape)].push_back(c);
    }
  }
  for (auto& [key, corners] : corners_by_shape) {  // the key begins with the cosine
    std::stable_sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
      return a.lengths.first < b.lengths.first;
    });
    CornerShape shape = corners.front().shape;
    shape.begin = corners_.size();
    for (const Corner& c : corners) {
      corners_.push_back(c.corner);
      lengths_.push_back(c.lengths);
      shape.longest.first = std::max(shape.longest.first, c.lengths.first);
      shape.longest.second = std::max(shape.longest.second, c.lengths.second);
      shape.longest.third = std::max(shape.longest.third, c.lengths.third);
    }
    shape.end = corners_.size();
    shapes_.push_back(shape);
  }
  std::stable_sort(shapes_.begin(), shapes_.end(),
                   [](const CornerShape& a, const CornerShape& b) { return a.cosine < b.cosine; });
  for (const CornerShape& shape : shapes_) {
    spans_.push_back({lengths_[shape.begin].first, shape.longest.first});
  }
}

std::pair<std::size_t, std::size_t> CornerIndex::shapes_between(double low, double high) const {
  const double from = std::cos(std::min(high, 3.1416)), to = std::cos(std::max(low, 0.0));
  const auto first =
      std::lower_bound(shapes_.begin(), shapes_.end(), from,
                       [](const CornerShape& s, double value) { return s.cosine < value; });
  const auto last =
      std::upper_bound(first, shapes_.end(), to,
                       [](double value, const CornerShape& s) { return value < s.cosine; });
  return {static_cast<std::size_t>(first - shapes_.begin()),
          static_cast<std::size_t>(last - shapes_.begin())};
}

std::pair<std::size_t, std::size_t> CornerIndex::search(const CornerShape& shape, double low,
                                                        double high) const {
  const auto begin = lengths_.begin() + static_cast<std::ptrdiff_t>(shape.begin);
  const auto end = lengths_.begin() + static_cast<std::ptrdiff_t>(shape.end);
  const auto first = std::lower_bound(
      begin, end, low, [](const CornerLengths& l, double value) { return l.first < value; });
  const auto last = std::upper_bound(
      first, end, high, [](double value, const CornerLengths& l) { return value < l.first; });
  return {static_cast<std::size_t>(first - lengths_.begin()),
          static_cast<std::size_t>(last - lengths_.begin())};
}

}  // namespace trihedron
