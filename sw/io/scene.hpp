// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "recognition/camera.hpp"
#include "recognition/evaluation.hpp"

namespace trihedron {

/// A scene folder in the BOP layout.
struct Scene {
  int id = 0;                   ///< the number in the folder's name, 0 without one
  std::string name;             ///< the folder's name
  std::string kind;             ///< "lab-hd-stacked" ... from scene_kind.json, "" without that file
  std::vector<int> im_ids;      ///< per view, ascending
  std::vector<Camera> cameras;  ///< per view
  std::vector<cv::Mat> images;  ///< per view, 8-bit grey
  std::optional<std::vector<TrueObject>> truth;  ///< from scene_gt.json
};

/// Reads scene_camera.json, the views' images (gray/NNNNNN.png; also .tif, .jpg, .bmp, .pgm, and
/// rgb/ in place of gray/) and, if there, scene_gt.json and scene_kind.json.
///
/// scene_camera.json holds per view cam_K (9 numbers, px), cam_R_w2c (9), cam_t_w2c (3, mm);
/// optional cam_dist (OpenCV's k1 k2 p1 p2 k3), cam_model "orthographic" with px_per_mm, view,
/// width and height. Views may differ in size only where width and height say so.
///
/// Throws Error with file and field: missing or unreadable file, broken JSON, a K or rotation
/// that is none, an image whose size does not fit its camera or the other views, fewer than two
/// views.
Scene read_scene(const std::filesystem::path& folder);

/// The scene folders of a data set: those that hold scene_camera.json, at most two levels below
/// `dataset`, or `dataset` itself; by name. Throws Error when there is none.
std::vector<std::filesystem::path> find_scenes(const std::filesystem::path& dataset);

}  // namespace trihedron
