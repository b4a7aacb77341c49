// SPDX-License-Identifier: Apache-2.0
#include "report/space.hpp"

#include <Eigen/Dense>

namespace trihedron::report {
namespace {

Ray axis_of(const Camera& camera) {
  return camera.ray({(camera.width_px - 1) / 2.0, (camera.height_px - 1) / 2.0});
}

}  // namespace

Eigen::Vector3d looked_at(const std::vector<Camera>& cameras) {
  // Least squares over the distances from the axes; the small term keeps parallel axes solvable.
  constexpr double kTowardsOrigin = 1e-9;
  Eigen::Matrix3d normal = kTowardsOrigin * Eigen::Matrix3d::Identity();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Camera& camera : cameras) {
    const Ray axis = axis_of(camera);
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - axis.direction * axis.direction.transpose();
    normal += across;
    right += across * axis.origin;
  }
  return normal.ldlt().solve(right);
}

Json space_camera(const Camera& camera, const Eigen::Vector3d& focus) {
  const double x = camera.width_px - 0.5, y = camera.height_px - 0.5;  // outer rims of the pixels
  const Ray axis = axis_of(camera);
  const Eigen::Vector3d forward = camera.camera_from_world.R.row(2);
  Json origins = Json::array(), directions = Json::array();
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(x, -0.5),
                                        Eigen::Vector2d(x, y), Eigen::Vector2d(-0.5, y)}) {
    const Ray ray = camera.ray(corner);
    append(origins, ray.origin);
    for (double d : ray.direction / ray.direction.dot(forward)) directions.push_back(rounded(d, 6));
  }
  return {{"name", camera.view},
          {"orthographic", camera.projection == Camera::Projection::kOrthographic},
          {"focal_px", rounded(camera.K(0, 0), 2)},
          {"position", numbers(axis.origin)},
          {"distance", rounded((focus - axis.origin).dot(forward), 3)},
          {"px_per_mm", rounded(camera.px_per_mm_at(focus), 4)},
          {"origins", origins},
          {"directions", directions}};
}

Json space_model(const PlacedModel& placed) {
  const Model& model = *placed.model;
  Json vertices = Json::array(), triangles = Json::array(), surfaces = Json::array(),
       edges = Json::array();
  for (const Eigen::Vector3d& x : model.mesh.vertices)
    append(vertices, placed.world_from_model * x);
  for (std::size_t s = 0; s < model.surfaces.size(); ++s)
    for (int t : model.surfaces[s].triangles) {
      for (int v : model.mesh.triangles[static_cast<std::size_t>(t)]) triangles.push_back(v);
      surfaces.push_back(s);
    }
  for (const ModelEdge& edge : model.edges) {
    edges.push_back(edge.v0);
    edges.push_back(edge.v1);
  }
  return {{"name", model.name},
          {"vertices", vertices},
          {"triangles", triangles},
          {"surfaces", surfaces},
          {"edges", edges}};
}

Json space_edges(const std::vector<SpaceEdge>& edges) {
  Json list = Json::array();
  for (const SpaceEdge& edge : edges) {
    Json line = numbers(edge.end[0]);
    append(line, edge.end[1]);
    list.push_back({{"line", line},
                    {"views", 2 + edge.confirmations},
                    {"ends", edge.agreed[0] + edge.agreed[1]}});
  }
  return list;
}

}  // namespace trihedron::report
