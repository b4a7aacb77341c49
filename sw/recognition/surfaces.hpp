// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

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
  int in_pieces = 0;                     ///< regions that an unfinished contour divides
  int incomplete = 0;                    ///< regions with a corner that found no partner
  int not_planar = 0;                    ///< regions whose corners found false partners
  int contradicted = 0;                  ///< regions that miss a corner seen in front of them
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
/// surface when no unfinished contour divides it, every corner finds a partner, all lie within
/// 2 `error_mm` of a plane, and no corner of a top surface stands in front of it without being
/// one of the region's corners.
/// `views` and `regions` in the order top, side, front.
CrossingResult cross_views(const std::array<PlanarView, 3>& views,
                           const std::array<std::vector<Region>, 3>& regions, double error_mm);

/// Removes surfaces that a higher view (top before side before front) already holds: area,
/// perimeter, edge count, normal and centroid within 20 % (eqs. 9-13), the centroid relative to
/// its distance from `table_corner` (mm, world). Top surfaces are never removed.
std::vector<CrossedSurface> without_duplicates(const std::vector<CrossedSurface>& surfaces,
                                               const Eigen::Vector3d& table_corner);

}  // namespace trihedron
