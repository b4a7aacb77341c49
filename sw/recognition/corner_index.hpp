// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// Two edges that leave a vertex of a model: what an observed corner is compared with. Its frame:
/// x along the first edge, the second edge in the half plane y > 0 of z = 0.
struct ModelCorner {
  int model = 0;                      ///< index into the library
  Eigen::Vector3d position;           ///< of the vertex, model frame, mm
  Eigen::Matrix3d model_from_corner;  ///< rotation
};

/// Lengths in mm of a corner's first and second edge and of a third one, apart from the rest of
/// the corner: they are scanned by the thousand.
struct CornerLengths {
  float first = 0, second = 0, third = 0;
};

/// What corners of many models have in common: where their edges leave to and their surfaces turn
/// to, in the corner's frame. Most corners of manufactured parts are right-angled, so thousands of
/// them are judged by what the views show along the few directions of a shape.
struct CornerShape {
  double cosine = 0, sine = 1;  ///< of the angle between the two edges
  Eigen::Vector3d third;        ///< unit, along the longest of the vertex's other edges
  std::array<std::array<Eigen::Vector3d, 2>, 3> normals;  ///< of the surfaces at the three edges
  CornerLengths longest;                                  ///< over its corners
  std::size_t begin = 0, end = 0;                         ///< its corners
};

/// The corners of a library, by shape. Of corners that a symmetry of their model maps onto each
/// other only one is kept: the others would give the same poses.
class CornerIndex {
 public:
  explicit CornerIndex(const std::vector<Model>& library);

  /// By growing cosine.
  const std::vector<CornerShape>& shapes() const { return shapes_; }
  /// The shapes whose angle lies between `low` and `high` rad: [first, second).
  std::pair<std::size_t, std::size_t> shapes_between(double low, double high) const;
  /// The corners of the shape with that index whose first edge is between `low` and `high` mm long:
  /// [first, second), by growing length of the first edge.
  std::pair<std::size_t, std::size_t> corners_between(std::size_t shape, double low,
                                                      double high) const {
    const Span& span = spans_[shape];
    if (span.longest < low || span.shortest > high) return {0, 0};
    return search(shapes_[shape], low, high);
  }
  std::size_t size() const { return corners_.size(); }
  const ModelCorner& corner(std::size_t i) const { return corners_[i]; }
  const CornerLengths& lengths(std::size_t i) const { return lengths_[i]; }

 private:
  /// Of a shape's first edges, mm: most shapes are passed over by a look at this.
  struct Span {
    float shortest, longest;
  };
  std::pair<std::size_t, std::size_t> search(const CornerShape& shape, double low,
                                             double high) const;

  std::vector<CornerShape> shapes_;
  std::vector<Span> spans_;
  std::vector<ModelCorner> corners_;
  std::vector<CornerLengths> lengths_;
};

}  // namespace trihedron
