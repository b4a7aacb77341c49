// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/model.hpp"

namespace trihedron {

/// A closed polygon in space, mm.
using SpacePolygon = std::vector<Eigen::Vector3d>;

/// What a planar surface is compared by. All of it is computed from the vertices, for models
/// and scenes alike.
struct SurfaceAttributes {
  double area = 0;                                     ///< mm^2, holes taken out
  double perimeter = 0;                                ///< mm, holes included
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit, to the side from which the outer
                                                       ///< loop runs counter-clockwise
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the area, mm
  std::vector<double> edge_lengths;                    ///< mm, all loops in order
  std::vector<Eigen::Vector3d> edge_middles;           ///< mm, same order

  int edges() const { return static_cast<int>(edge_lengths.size()); }
};

/// The attributes of a polygon with holes: loops[0] is the outer boundary, the others run the
/// other way round. Loops that are not quite planar are taken as their projection along the
/// area-weighted mean normal. An empty or degenerate outer loop has area 0 and normal 0.
SurfaceAttributes surface_attributes(const std::vector<SpacePolygon>& loops);

/// The same of surface `index` of a model, in the model frame.
SurfaceAttributes surface_attributes(const Model& model, int index);

/// The loops of surface `index` of a model as points, mm, model frame.
std::vector<SpacePolygon> surface_loops(const Model& model, int index);

}  // namespace trihedron
