// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recognition/camera.hpp"
#include "render/view.hpp"
#include "render/world.hpp"

namespace trihedron::render {

/// A rendered scene with everything that its folder says about it.
struct RenderedScene {
  std::string look, rig;
  bool stacked = false, leaning = false;
  World world;
  std::vector<Camera> cameras;           ///< the ones that took the pictures
  std::vector<Camera> reported_cameras;  ///< what the calibration says of them
  std::vector<RenderedView> views;
};

/// Writes gray/, surfaces/, scene_camera.json, scene_gt.json, scene_gt_info.json, scene_kind.json
/// and surface_table.json. The poses of scene_gt.json are those in the true cameras' frames.
/// Throws Error when the folder cannot be written.
void write_scene(const std::filesystem::path& folder, const RenderedScene& scene);

/// The cameras of a scene_camera.json, by view. Their size comes from width and height, else from
/// a principal point in the middle of the image. Throws Error with file and field.
std::vector<Camera> read_cameras(const std::filesystem::path& file);

/// The objects of a scene_gt.json, from the poses of the cameras' first view. Throws Error with
/// file and field, or when the library has no such model.
std::vector<PlacedObject> read_objects(const std::filesystem::path& file,
                                       const std::vector<Camera>& cameras,
                                       const std::vector<Model>& library);

}  // namespace trihedron::render
