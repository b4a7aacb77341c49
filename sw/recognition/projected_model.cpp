// SPDX-License-Identifier: Apache-2.0
#include "recognition/projected_model.hpp"

namespace trihedron {
namespace {

/// Sine of the angle between a surface and the line of sight below which the surface counts as
/// seen edge-on: rounding in an axis-aligned orthographic view must not show it. A surface of
/// 100 mm at this angle is 0.02 px wide at 2 px/mm.
constexpr double kEdgeOnSine = 1e-4;

void grow(ProjectedModel::Box& box, const Eigen::Vector2d& x) {
  box.low = box.low.cwiseMin(x);
  box.high = box.high.cwiseMax(x);
}

ProjectedModel::Box empty_box() {
  return {Eigen::Vector2d::Constant(1e300), Eigen::Vector2d::Constant(-1e300)};
}

}  // namespace

bool faces_camera(const Camera& camera, const Eigen::Vector3d& normal, double offset,
                  double distance) {
  // Pinhole: the camera centre lies outside the surface's plane; orthographic: the normal
  // points against the line of sight.
  if (camera.projection == Camera::Projection::kPinhole) return -offset > kEdgeOnSine * distance;
  return -normal.z() > kEdgeOnSine;
}

ProjectedModel project_model(const Camera& camera, const PlacedModel& placed) {
  const Model& model = *placed.model;
  const Transform camera_from_model = camera.camera_from_world * placed.world_from_model;
  const bool pinhole = camera.projection == Camera::Projection::kPinhole;
  ProjectedModel out;
  out.model = &model;
  out.box = empty_box();
  out.x_in_camera.reserve(model.mesh.vertices.size());
  out.ideal.reserve(model.mesh.vertices.size());
  out.normals.reserve(model.surfaces.size());
  out.offsets.reserve(model.surfaces.size());
  out.front.reserve(model.surfaces.size());
  out.boxes.reserve(model.surfaces.size());
  bool in_front = true;
  for (const Eigen::Vector3d& vertex : model.mesh.vertices) {
    const Eigen::Vector3d x = camera_from_model * vertex;
    in_front = in_front && x.z() > 1.0;
    const double scale = pinhole ? 1.0 / std::max(x.z(), 1.0) : 1.0;
    out.x_in_camera.push_back(x);
    out.ideal.push_back(x.head<2>() * scale);
    grow(out.box, out.ideal.back());
  }
  for (const Surface& surface : model.surfaces) {
    const Eigen::Vector3d normal = camera_from_model.R * surface.normal;
    const double offset = surface.offset + normal.dot(camera_from_model.t);
    const Eigen::Vector3d centre = camera_from_model * surface.centroid;
    out.normals.push_back(normal);
    out.offsets.push_back(offset);
    out.front.push_back(in_front && faces_camera(camera, normal, offset, centre.norm()));
    out.boxes.push_back(empty_box());
    for (int v : surface.loops.front()) grow(out.boxes.back(), out.ideal[v]);
  }
  return out;
}

}  // namespace trihedron
