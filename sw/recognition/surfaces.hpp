// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "recognition/model.hpp"
#include "recognition/planar_view.hpp"
#include "recognition/regions.hpp"
#include "recognition/surface_attributes.hpp"

namespace trihedron {

/// A 3D surface made from one region.
struct CrossedSurface {
  ViewRole role = ViewRole::kTop;
  int region = 0;                   ///< index of the region in its view
  std::vector<SpacePolygon> loops;  ///< world, mm; loops[0] outer, counter-clockwise seen from
                                    ///< the camera; the others holes
  SurfaceAttributes attributes;     ///< world; the normal points to the camera
};

struct CrossingResult {
  std::vector<CrossedSurface> surfaces;  ///< described in 3D, top first, then side, front
  int incomplete = 0;                    ///< regions with a corner that found no partner
  int not_planar = 0;                    ///< regions whose corners found false partners
};

/// What the views measured of all corners of their regions, by role, world mm. Only the two
/// coordinates that the view measures are valid.
using MeasuredCorners = std::array<SpacePolygon, 3>;

MeasuredCorners measure_corners(const std::array<PlanarView, 3>& views,
                                const std::array<std::vector<Region>, 3>& regions);

/// Data crossing (eqs. 5-8): gives each corner of each region its third coordinate from the
/// corners of the other views that agree in the shared coordinate within `error_mm`. Top corners
/// take the largest z that side and front agree on, or else the largest of either; side and front
/// corners take from the top view the point nearest to their own camera. A region describes a
/// surface when every corner finds a partner and all lie within 2 `error_mm` of a plane.
/// `views` and `regions` in the order top, side, front.
CrossingResult cross_views(const std::array<PlanarView, 3>& views,
                           const std::array<std::vector<Region>, 3>& regions, double error_mm);

/// Removes surfaces that a higher view (top before side before front) already holds: area,
/// perimeter, edge count, normal and centroid within 20 % (eqs. 9-13), the centroid relative to
/// its distance from `table_corner` (mm, world). Top surfaces are never removed.
std::vector<CrossedSurface> without_duplicates(const std::vector<CrossedSurface>& surfaces,
                                               const Eigen::Vector3d& table_corner);

/// The paper's Error, mm. Corners of one point in two views differ by at most half a pixel each;
/// but more than half the smallest distance of two edges would confuse corners.
double crossing_error_mm(const std::array<PlanarView, 3>& views, const std::vector<Model>& library);

/// Smallest distance between two edges of the model that share no vertex, mm.
double smallest_edge_gap_mm(const Model& model);

}  // namespace trihedron
