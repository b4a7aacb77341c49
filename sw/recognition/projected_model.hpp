// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/visibility.hpp"

namespace trihedron {

/// A placed model as a camera without lens distortion sees it: straight edges stay straight.
/// Ideal coordinates are x/z, y/z of the camera frame (pinhole) or x, y in mm (orthographic).
struct ProjectedModel {
  struct Box {
    Eigen::Vector2d low, high;
  };

  const Model* model = nullptr;
  std::vector<Eigen::Vector3d> x_in_camera;  ///< vertices, mm
  std::vector<Eigen::Vector2d> ideal;        ///< vertices
  std::vector<Eigen::Vector3d> normals;      ///< surfaces, camera frame
  std::vector<double> offsets;               ///< surfaces: normal . x = offset, camera frame
  std::vector<char> front;                   ///< surfaces: turned towards the camera
  std::vector<Box> boxes;                    ///< surfaces, ideal coordinates
  Box box;                                   ///< the whole model
};

/// Whether a surface of that plane (normal . x = offset, camera frame) is turned towards the
/// camera. Seen edge-on within rounding, at `distance` mm from the camera, it is not.
bool faces_camera(const Camera& camera, const Eigen::Vector3d& normal, double offset,
                  double distance);

/// Throws nothing; a model that reaches behind a pinhole camera has no front surfaces.
ProjectedModel project_model(const Camera& camera, const PlacedModel& placed);

}  // namespace trihedron
