// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/look.hpp"
#include "render/placement.hpp"
#include "render/rig.hpp"
#include "render/scene_files.hpp"

namespace trihedron::render {

/// How to make a scene. What is left open is drawn from the look's ranges.
struct GenerateOptions {
  std::string look = "studio";
  RigOptions rig;
  PlacementOptions placement;
  std::optional<double> noise, blur_px, grain, vignetting;  ///< as Sensor's
  double contrast = 1;                                      ///< as Sensor's
  std::optional<bool> shadows;                              ///< the lamps cast shadows
  double calibration_error_px = 0;  ///< of the reported cameras, see miscalibrated()
  std::vector<Camera> cameras;      ///< instead of the rig's
  int threads = 0;                  ///< 0: as many as the machine has
};

/// Scene number `index` of the series `seed`: cameras, placement, light and pictures. The result
/// depends on nothing else, neither on earlier scenes nor on the number of threads.
/// Throws Error as make_rig, make_look, place_objects and render_view do.
RenderedScene generate_scene(const std::vector<Model>& library, const GenerateOptions& options,
                             std::uint64_t seed, int index);

/// The same, with the objects given instead of placed at random.
RenderedScene generate_scene(const std::vector<PlacedObject>& objects,
                             const GenerateOptions& options, std::uint64_t seed, int index);

}  // namespace trihedron::render
