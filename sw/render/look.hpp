// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/random.hpp"
#include "render/rig.hpp"
#include "render/sensor.hpp"
#include "render/world.hpp"

namespace trihedron::render {

/// A range that a scene draws a value from.
struct Range {
  double low = 0, high = 0;
  double draw(Random& random) const { return random.uniform(low, high); }
};

/// The conditions a picture is taken under. Light levels are grey levels on a surface of albedo 1.
struct Look {
  std::string name;
  Range albedo;        ///< of the objects
  Range ambient;       ///< light from everywhere
  Range key, fill;     ///< the two lamps, on a surface that faces them
  Range key_size_rad;  ///< radius over distance; 0: hard shadows
  bool shadows = false;
  bool table = true;
  Range table_albedo;
  Range background;                         ///< grey level behind the table
  Range vignetting, grain, blur_px, noise;  ///< as Sensor's
};

/// "cad": flat shading on a dark ground, no noise; "studio": soft light, no shadows, mild noise;
/// "lab": soft and hard shadows, grain, blur, noise. Throws Error for another name.
Look make_look(const std::string& name);

/// Gives the scene's objects their albedos, and the scene its table and lamps; returns the sensor.
Sensor dress(const Look& look, const Field& field, World& world, Random& random);

}  // namespace trihedron::render
