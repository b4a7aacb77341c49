// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// Two edges that leave a vertex of a model: what an observed corner is compared with.
struct ModelCorner {
  int model = 0;  ///< index into the library
  int vertex = 0;
  Eigen::Vector3d position;                      ///< of the vertex, model frame, mm
  Eigen::Vector3d along;                         ///< unit, along the first edge
  Eigen::Vector3d aside;                         ///< unit, along the second edge
  double length = 0;                             ///< of the first edge, mm
  double aside_length = 0;                       ///< of the second edge, mm
  double angle = 0;                              ///< between them, rad
  std::array<Eigen::Vector3d, 2> along_normals;  ///< of the surfaces at the first edge
  std::array<Eigen::Vector3d, 2> aside_normals;  ///< of the surfaces at the second edge
};

/// An edge of a model walked one way.
struct DirectedEdge {
  int model = 0;         ///< index into the library
  int edge = 0;          ///< index into Model::edges
  int from = 0, to = 0;  ///< vertices
  double length = 0;     ///< mm
};

/// An edge of a model and its two surfaces, packed for scanning.
struct EdgeSketch {
  Eigen::Vector3f x0, x1;                   ///< ends, model frame, mm
  Eigen::Vector3f left, right;              ///< normals of its surfaces
  float left_offset = 0, right_offset = 0;  ///< normal . x on the surface, mm
};

/// What is asked of a model for every pose.
struct ModelSketch {
  std::vector<EdgeSketch> edges;  ///< longest first: they are the surest seen
  Eigen::Vector3d vertex_mean;    ///< model frame, mm; every symmetry leaves it in place
  double diameter = 0;            ///< mm
};

/// The corners of a library, ordered for look-up. Of corners that a symmetry of their model maps
/// onto each other, only one is kept: the others would give the same poses.
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
  /// Corners whose first edge is between `low` and `high` mm long.
  Range<ModelCorner> by_length(double low, double high) const;
  /// Corners with an angle between `low` and `high` rad.
  Range<ModelCorner> by_angle(double low, double high) const;
  /// Edges between `low` and `high` mm long, both ways unless a symmetry makes them one.
  Range<DirectedEdge> edges_by_length(double low, double high) const;
  /// The sketch of a model, by its index in the library.
  const ModelSketch& sketch(int model) const { return sketches_[static_cast<std::size_t>(model)]; }

 private:
  std::vector<ModelSketch> sketches_;
  std::vector<ModelCorner> by_length_, by_angle_;
  std::vector<DirectedEdge> edges_;
};

}  // namespace trihedron
