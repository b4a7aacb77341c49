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

/// The corners of a library, ordered for look-up. Of corners that a symmetry of their model maps
/// onto each other, only one is kept: the others would give the same poses.
class LibraryIndex {
 public:
  explicit LibraryIndex(const std::vector<Model>& library);

  /// Corners whose first edge is between `low` and `high` mm long.
  struct Range {
    const ModelCorner* first;
    const ModelCorner* last;
    const ModelCorner* begin() const { return first; }
    const ModelCorner* end() const { return last; }
  };
  Range by_length(double low, double high) const;
  /// Corners with an angle between `low` and `high` rad.
  Range by_angle(double low, double high) const;

 private:
  std::vector<ModelCorner> by_length_, by_angle_;
};

}  // namespace trihedron
