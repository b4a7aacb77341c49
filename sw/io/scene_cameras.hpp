// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/json_field.hpp"
#include "recognition/camera.hpp"

namespace trihedron {

/// A camera from one entry of scene_camera.json; width and height stay 0 when not given.
/// Throws Error with the field that is wrong.
Camera parse_camera(const JsonField& entry);

/// A rigid motion from an entry's row-major rotation and its translation in mm. Throws Error
/// unless the nine numbers are a proper rotation to the digits that files hold; they are made
/// one exactly.
Transform parse_motion(const JsonField& entry, const std::string& rotation_key,
                       const std::string& translation_key);

/// Throws Error when the image does not fit the camera: another size than width and height say, or
/// a principal point at its border or outside. `place` is the camera's entry, for the message.
void check_image_size(const Camera& camera, const std::string& place, const std::string& image_name,
                      int width_px, int height_px);

/// The view numbers that are the keys of a BOP file, ascending. Throws Error on other keys.
std::vector<int> view_numbers(const JsonField& root);

/// A camera and the number of its images.
struct ViewCamera {
  int im_id = 0;
  Camera camera;      ///< without a name in the file: "top", "side", "front", "3" ...
  std::string place;  ///< file and entry, for messages
};

/// The cameras of a scene_camera.json, by number. Throws Error with the field that is wrong, and
/// with fewer than two views.
std::vector<ViewCamera> read_cameras(const std::filesystem::path& file);

/// A camera as an entry of scene_camera.json; parse_camera() reads it back.
nlohmann::ordered_json camera_json(const Camera& camera);

/// Writes scene_camera.json with the cameras numbered from 0; never seen half written.
void write_cameras(const std::filesystem::path& file, const std::vector<Camera>& cameras);

}  // namespace trihedron
