// SPDX-License-Identifier: Apache-2.0
#include "recognition/planar_view.hpp"

#include <cmath>

#include "golden/error.hpp"

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::array<const char*, 3> kRoleNames = {"top", "side", "front"};

ViewRole role_of(const Camera& camera) {
  const Vector3d sight = camera.camera_from_world.R.row(2).transpose().cwiseAbs();
  if (sight.z() >= sight.x() && sight.z() >= sight.y()) return ViewRole::kTop;
  return sight.y() >= sight.x() ? ViewRole::kSide : ViewRole::kFront;
}

PlanarView planar_view(const Camera& camera, int index) {
  PlanarView view;
  view.view = index;
  view.role = role_of(camera);
  view.camera = camera;
  const Eigen::Matrix3d& R = camera.camera_from_world.R;
  view.right = R.row(0).transpose();
  view.down = R.row(1).transpose();
  view.towards = -R.row(2).transpose();
  return view;
}

Vector3d centre_of_table(const Camera& top) {
  const Ray ray = top.ray({0.5 * (top.width_px - 1), 0.5 * (top.height_px - 1)});
  if (ray.direction.z() == 0) return ray.origin;
  return ray.origin - ray.origin.z() / ray.direction.z() * ray.direction;
}

}  // namespace

Vector3d PlanarView::measure(const Vector2d& pixel) const {
  const Vector2d d = mm_per_px * (camera.undistort(pixel) - table_centre_px);
  return table_centre + d.x() * right + d.y() * down;
}

std::array<PlanarView, 3> planar_views(const std::vector<Camera>& cameras) {
  std::array<PlanarView, 3> views;
  std::array<int, 3> found = {0, 0, 0};
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const PlanarView view = planar_view(cameras[i], static_cast<int>(i));
    const auto slot = static_cast<std::size_t>(view.role);
    ++found[slot];
    views[slot] = view;
  }
  for (std::size_t slot = 0; slot < 3; ++slot) {
    if (found[slot] == 1) continue;
    throw Error(
        "cameras: method paper needs one top, one side and one front view (looking along "
        "z, y and x), got " +
        std::to_string(found[slot]) + " " + kRoleNames[slot] + " views");
  }
  const Vector3d centre = centre_of_table(views[0].camera);
  for (PlanarView& view : views) {
    view.table_centre = centre;
    view.table_centre_px = view.camera.undistort(view.camera.project(centre));
    view.mm_per_px = 1 / view.camera.px_per_mm_at(centre);
  }
  return views;
}

Vector3d table_corner(const PlanarView& top) {
  const double right = top.camera.width_px - 1, bottom = top.camera.height_px - 1;
  Vector3d corner = top.table_centre;
  for (const Vector2d& px :
       {Vector2d(0, 0), Vector2d(right, 0), Vector2d(0, bottom), Vector2d(right, bottom)}) {
    corner = corner.cwiseMin(top.measure(px));
  }
  corner.z() = 0;
  return corner;
}

}  // namespace trihedron
