// SPDX-License-Identifier: Apache-2.0
#include "render/look.hpp"

#include <cmath>

#include "golden/error.hpp"

namespace trihedron::render {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr Range kKeyElevation{38 * kDegree, 60 * kDegree};
constexpr Range kFillElevation{25 * kDegree, 50 * kDegree};
// The key stands between the side and the front camera or next to them; the fill anywhere.
constexpr Range kKeyAzimuth{-105 * kDegree, 15 * kDegree};
constexpr Range kFillAzimuth{-180 * kDegree, 180 * kDegree};
constexpr Range kLampDistance_mm{1200, 2600};
constexpr Range kTableHalf_mm{230, 340};  // of each axis, beyond a field of the paper's size
constexpr double kPaperHalfField_mm = 110;

Light lamp(const Range& elevation, const Range& azimuth, const Range& intensity, double size_rad,
           bool shadows, Random& random) {
  const double e = elevation.draw(random), a = azimuth.draw(random);
  Light light;
  const double distance_mm = kLampDistance_mm.draw(random);
  light.position = distance_mm * Eigen::Vector3d(std::cos(e) * std::cos(a),
                                                 std::cos(e) * std::sin(a), std::sin(e));
  light.radius_mm = distance_mm * size_rad;
  light.intensity = intensity.draw(random);
  light.casts_shadows = shadows;
  return light;
}

}  // namespace

Look make_look(const std::string& name) {
  Look look;
  look.name = name;
  if (name == "cad") {
    look.albedo = {0.90, 1.05};
    look.ambient = {75, 90};
    look.key = {90, 115};
    look.fill = {0, 15};
    look.table = false;
    look.background = {39, 39};
  } else if (name == "studio") {
    look.albedo = {0.85, 1.08};
    look.ambient = {75, 95};
    look.key = {95, 120};
    look.fill = {5, 20};
    look.table_albedo = {0.22, 0.38};
    look.background = {0, 60};
    look.blur_px = {0.50, 0.65};
    look.noise = {1.0, 1.4};
  } else if (name == "lab") {
    look.albedo = {0.75, 1.10};
    look.ambient = {45, 58};
    look.key = {110, 145};
    look.fill = {8, 22};
    look.key_size_rad = {0.015, 0.07};
    look.shadows = true;
    look.table_albedo = {0.44, 0.60};
    look.background = {45, 95};
    look.vignetting = {0.05, 0.15};
    look.grain = {0.4, 0.7};
    look.blur_px = {0.65, 0.85};
    look.noise = {2.1, 2.7};
  } else {
    throw Error("look '" + name + "' is not known; it must be cad, studio or lab");
  }
  return look;
}

Sensor dress(const Look& look, const Field& field, World& world, Random& random) {
  for (PlacedObject& object : world.objects) object.albedo = look.albedo.draw(random);
  world.ambient = look.ambient.draw(random);
  world.background = look.background.draw(random);
  world.lights.clear();
  world.lights.push_back(lamp(kKeyElevation, kKeyAzimuth, look.key, look.key_size_rad.draw(random),
                              look.shadows, random));
  world.lights.push_back(lamp(kFillElevation, kFillAzimuth, look.fill, 0, look.shadows, random));

  world.table.present = look.table;
  world.table.albedo = look.table_albedo.draw(random);
  const double grow = field.half_size.x() / kPaperHalfField_mm;
  const Eigen::Vector2d low{kTableHalf_mm.draw(random), kTableHalf_mm.draw(random)};
  const Eigen::Vector2d high{kTableHalf_mm.draw(random), kTableHalf_mm.draw(random)};
  // A larger field has a larger table, but not in proportion: its border comes into view.
  world.table.min = field.centre - std::sqrt(grow) * low;
  world.table.max = field.centre + std::sqrt(grow) * high;

  Sensor sensor;
  sensor.vignetting = look.vignetting.draw(random);
  sensor.grain = look.grain.draw(random);
  sensor.blur_px = look.blur_px.draw(random);
  sensor.noise = look.noise.draw(random);
  return sensor;
}

}  // namespace trihedron::render
