// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "recognition/corner_index.hpp"
#include "recognition/model.hpp"

namespace trihedron {

/// An edge of a model walked one way.
struct DirectedEdge {
  int model = 0;         ///< index into the library
  int edge = 0;          ///< index into Model::edges
  int from = 0, to = 0;  ///< vertices
  double length = 0;     ///< mm
};

/// What is asked of a model for every pose, packed for scanning.
struct ModelSketch {
  struct Surface {
    Eigen::Vector3f normal;  ///< model frame
    float offset;            ///< normal . x on it, mm
  };
  /// An edge by its vertices and surfaces, and its index in Model::edges.
  struct Edge {
    int v0, v1, left, right, index;
    float length;  ///< mm
  };

  std::vector<Eigen::Vector3f> vertices;  ///< model frame, mm
  std::vector<Surface> surfaces;
  std::vector<Edge> edges;      ///< longest first: they are the surest seen
  Eigen::Vector3d vertex_mean;  ///< model frame, mm; every symmetry leaves it in place
  double diameter = 0;          ///< mm

  /// The edges that are `low` to `high` mm long.
  std::pair<const Edge*, const Edge*> edges_by_length(double low, double high) const;
  /// Of a pose's lowest vertex, world, mm.
  float lowest(const Transform& world_from_model) const;
};

/// A library's corners, edges and sketches, ordered for look-up.
class LibraryIndex {
 public:
  explicit LibraryIndex(const std::vector<Model>& library);

  /// A run of entries.
  template <typename T>
  struct Range {
    const T* first;
    const T* last;
    const T* begin() const { return first; }
    const T* end() const { return last; }
  };
  const CornerIndex& corners() const { return corners_; }
  /// Edges between `low` and `high` mm long, both ways unless a symmetry makes them one.
  Range<DirectedEdge> edges_by_length(double low, double high) const;
  /// The sketch of a model, by its index in the library.
  const ModelSketch& sketch(int model) const { return sketches_[static_cast<std::size_t>(model)]; }

 private:
  CornerIndex corners_;
  std::vector<ModelSketch> sketches_;
  std::vector<DirectedEdge> edges_;
};

}  // namespace trihedron
