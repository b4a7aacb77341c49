// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// Throws Error, with the field, when the image does not fit the camera: another size than
/// width and height say, or a principal point at its border or outside.
void check_image_size(const Camera& camera, const JsonField& entry, const std::string& image_name,
                      int width_px, int height_px);

}  // namespace trihedron
