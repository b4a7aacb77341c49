// SPDX-License-Identifier: Apache-2.0
// Exact orthographic scenes for the tests of method paper: regions without a front end.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "recognition/planar_view.hpp"
#include "recognition/region_polygon.hpp"
#include "recognition/regions.hpp"
#include "recognition/rigs.hpp"
#include "recognition/surface_attributes.hpp"

namespace trihedron::paper_scenes {

constexpr double kPxPerMm = 2.0473;  // of rigs::look_at

/// Top, side and front exactly along the axes, around (0, 0, 30).
inline std::vector<Camera> exact_views(bool pinhole = false) {
  const Eigen::Vector3d target(0, 0, 30);
  return {rigs::look_at({0, 0, 630}, target, Eigen::Vector3d::UnitY(), pinhole),
          rigs::look_at({0, -600, 30}, target, Eigen::Vector3d::UnitZ(), pinhole),
          rigs::look_at({600, 0, 30}, target, Eigen::Vector3d::UnitZ(), pinhole)};
}

/// The region that `camera` sees of a polygon in the world, mm.
inline Region region_of(const Camera& camera, const SpacePolygon& polygon) {
  Region region;
  for (const Eigen::Vector3d& p : polygon) region.outer.push_back(camera.project(p));
  if (signed_area(region.outer) > 0) std::reverse(region.outer.begin(), region.outer.end());
  region.area_px2 = -signed_area(region.outer);
  return region;
}

/// The regions of all surfaces of a model that face each camera. Right only where no surface
/// hides another one.
inline std::array<std::vector<Region>, 3> regions_of(const std::vector<Camera>& cameras,
                                                     const Model& model,
                                                     const Transform& world_from_model) {
  std::array<std::vector<Region>, 3> regions;
  for (std::size_t v = 0; v < 3; ++v) {
    const Eigen::Vector3d sight = cameras[v].camera_from_world.R.row(2).transpose();
    for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
      if ((world_from_model.R * model.surfaces[i].normal).dot(sight) > -0.05) continue;
      SpacePolygon polygon = surface_loops(model, static_cast<int>(i))[0];
      for (Eigen::Vector3d& p : polygon) p = world_from_model * p;
      regions[v].push_back(region_of(cameras[v], polygon));
    }
  }
  return regions;
}

/// Standing on the table, turned by `degrees` about the vertical.
inline Transform standing(double degrees, double height) {
  return rigs::pose({0, 0, degrees * 3.14159265358979323846 / 180}, {5, -4, height / 2});
}

}  // namespace trihedron::paper_scenes
