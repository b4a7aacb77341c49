// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "golden/front_end.hpp"
#include "recognition/camera.hpp"
#include "recognition/recognize.hpp"
#include "recognition/shapes.hpp"
#include "recognition/visibility.hpp"

namespace trihedron::rigs {

/// A camera at `centre` (mm) that looks at `target`; `up` is up in the image.
inline Camera look_at(const Eigen::Vector3d& centre, const Eigen::Vector3d& target,
                      const Eigen::Vector3d& up, bool pinhole = true) {
  Camera camera;
  const Eigen::Vector3d z = (target - centre).normalized();
  const Eigen::Vector3d x = z.cross(up).normalized();
  camera.camera_from_world.R << x.transpose(), z.cross(x).transpose(), z.transpose();
  camera.camera_from_world.t = -(camera.camera_from_world.R * centre);
  camera.K << 1228.4, 0, 224.5, 0, 1228.4, 149.5, 0, 0, 1;
  camera.px_per_mm = 2.0473;
  camera.width_px = 450;
  camera.height_px = 300;
  if (!pinhole) camera.projection = Camera::Projection::kOrthographic;
  return camera;
}

/// Top, side and front, 600 mm from the table's middle, a few degrees off the axes.
inline std::vector<Camera> three_views(bool pinhole = true) {
  const Eigen::Vector3d target(0, 0, 30);
  return {look_at({10, -15, 630}, target, Eigen::Vector3d::UnitY(), pinhole),
          look_at({12, -600, 60}, target, Eigen::Vector3d::UnitZ(), pinhole),
          look_at({600, 20, 50}, target, Eigen::Vector3d::UnitZ(), pinhole)};
}

/// A grey level that differs between any two surfaces with different normals.
inline double shade(const Eigen::Vector3d& normal_in_world) {
  return 120 + 40 * normal_in_world.z() + 30 * normal_in_world.x() - 20 * normal_in_world.y();
}

/// The image of `objects` on a dark ground, 16 samples a pixel, and its features.
inline ViewFeatures features_of(const Camera& camera, const std::vector<PlacedModel>& objects) {
  constexpr int kFine = 4;  // samples a pixel, each way
  constexpr int kScale = kFine * SurfaceMap::kCellPx;
  Camera fine = camera;  // pixel (0, 0) of the fine camera lies at sample (0, 0) of pixel (0, 0)
  fine.K.topRows<2>() *= kScale;
  fine.px_per_mm *= kScale;
  fine.K(0, 2) += 0.5 * (kFine - 1) * SurfaceMap::kCellPx;
  fine.K(1, 2) += 0.5 * (kFine - 1) * SurfaceMap::kCellPx;
  fine.width_px *= kScale;
  fine.height_px *= kScale;
  const SurfaceMap map = surface_map(fine, objects);
  std::vector<std::uint8_t> grey;
  for (int y = 0; y < camera.height_px; ++y) {
    for (int x = 0; x < camera.width_px; ++x) {
      double sum = 0;
      for (int i = 0; i < kFine * kFine; ++i) {
        const std::int32_t id =
            map.ids[(y * kFine + i / kFine) * map.columns + x * kFine + i % kFine];
        if (id == SurfaceMap::kNothing) {
          sum += 40;
          continue;
        }
        const PlacedModel& placed = objects[SurfaceMap::object_of(id)];
        sum += shade(placed.world_from_model.R *
                     placed.model->surfaces[SurfaceMap::surface_of(id)].normal);
      }
      grey.push_back(static_cast<std::uint8_t>(sum / (kFine * kFine) + 0.5));
    }
  }
  return golden::run_front_end(grey.data(), camera.width_px, camera.height_px, camera.width_px);
}

/// What the three views see of objects.
inline std::vector<View> views_of(const std::vector<PlacedModel>& objects) {
  std::vector<View> views;
  for (const Camera& camera : three_views())
    views.push_back({camera, features_of(camera, objects)});
  return views;
}

/// A model whose vertices' mean lies at its origin.
inline Model centred(int id, const std::string& name, Mesh mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : mesh.vertices) sum += v;
  for (Eigen::Vector3d& v : mesh.vertices) v -= sum / static_cast<double>(mesh.vertices.size());
  return build_model(id, name, mesh);
}

inline Model block(double x, double y, double z) {
  return centred(1, "block", shapes::block(x, y, z));
}

/// 60 x 50 x 40 mm, legs 20 mm thick.
inline Model l_bracket() {
  return centred(2, "L",
                 shapes::prism({{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 50}, {0, 50}}, 40));
}

/// A pose from a rotation vector (rad) and a position (mm).
inline Transform pose(const Eigen::Vector3d& rotation, const Eigen::Vector3d& position) {
  Transform out;
  const double angle = rotation.norm();
  if (angle > 0) out.R = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
  out.t = position;
  return out;
}

}  // namespace trihedron::rigs
