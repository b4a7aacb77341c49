// SPDX-License-Identifier: Apache-2.0
#include "render/generate.hpp"

namespace trihedron::render {
namespace {

// Every part of a scene draws from a stream of its own, so that an option that changes one (the
// noise, say) leaves the others (the placement) as they were.
enum Stream : std::uint64_t { kCameras, kPlacement, kLight, kCalibration, kPixels, kStreams };

Random stream(std::uint64_t seed, int index, Stream which) {
  return Random(seed, static_cast<std::uint64_t>(index) * kStreams + which);
}

std::vector<Camera> cameras_of(const GenerateOptions& options, std::uint64_t seed, int index) {
  if (!options.cameras.empty()) return options.cameras;
  Random random = stream(seed, index, kCameras);
  return make_rig(options.rig, random);
}

void set_lamps(const GenerateOptions& options, World& world) {
  if (!options.shadows) return;
  for (Light& light : world.lights) light.casts_shadows = *options.shadows;
}

Sensor sensor_of(const GenerateOptions& options, Sensor sensor) {
  sensor.noise = options.noise.value_or(sensor.noise);
  sensor.blur_px = options.blur_px.value_or(sensor.blur_px);
  sensor.grain = options.grain.value_or(sensor.grain);
  sensor.vignetting = options.vignetting.value_or(sensor.vignetting);
  sensor.contrast = options.contrast;
  return sensor;
}

}  // namespace

RenderedScene generate_scene(const std::vector<PlacedObject>& objects,
                             const GenerateOptions& options, std::uint64_t seed, int index) {
  RenderedScene scene;
  scene.look = options.look;
  scene.rig = options.rig.name;
  scene.stacked = options.placement.stacked;
  scene.leaning = options.placement.leaning;
  scene.cameras = cameras_of(options, seed, index);
  scene.world.objects = objects;

  Random light = stream(seed, index, kLight);
  const Sensor sensor = sensor_of(
      options, dress(make_look(options.look), rig_field(options.rig.name), scene.world, light));
  set_lamps(options, scene.world);

  Random calibration = stream(seed, index, kCalibration);
  Random pixels = stream(seed, index, kPixels);
  for (const Camera& camera : scene.cameras) {
    scene.reported_cameras.push_back(
        options.calibration_error_px > 0
            ? miscalibrated(camera, options.calibration_error_px, calibration)
            : camera);
    scene.views.push_back(render_view(scene.world, camera, sensor, pixels.bits(), options.threads));
  }
  return scene;
}

RenderedScene generate_scene(const std::vector<Model>& library, const GenerateOptions& options,
                             std::uint64_t seed, int index) {
  Random random = stream(seed, index, kPlacement);
  const std::vector<Camera> cameras = cameras_of(options, seed, index);
  const std::vector<PlacedObject> objects =
      place_objects(library, cameras, rig_field(options.rig.name), options.placement, random);
  return generate_scene(objects, options, seed, index);
}

}  // namespace trihedron::render
