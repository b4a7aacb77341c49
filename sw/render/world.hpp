// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/model.hpp"
#include "recognition/transform.hpp"

namespace trihedron::render {

/// Samples per pixel and axis: the truth image and the antialiasing share this grid.
constexpr int kSubsamples = 4;

/// A model at its place. `model` outlives the scene.
struct PlacedObject {
  const Model* model = nullptr;
  Transform world_from_model;
  double albedo = 1;  ///< reflected fraction of the light, relative to the look's brightness
};

/// A disc that shines on the scene. radius 0: a point, which casts hard shadows.
struct Light {
  Eigen::Vector3d position;  ///< world, mm
  double radius_mm = 0;
  double intensity = 0;  ///< grey levels on a surface of albedo 1 that faces it at the origin
  bool casts_shadows = true;
};

/// The rectangle z = 0 that objects stand on.
struct Table {
  bool present = true;
  Eigen::Vector2d min{0, 0}, max{0, 0};  ///< world, mm
  double albedo = 0.5;
};

/// Everything that a camera can see, and what lights it.
struct World {
  std::vector<PlacedObject> objects;
  Table table;
  std::vector<Light> lights;
  double ambient = 0;     ///< grey levels on a surface of albedo 1, from everywhere
  double background = 0;  ///< grey level where neither object nor table is
};

}  // namespace trihedron::render
