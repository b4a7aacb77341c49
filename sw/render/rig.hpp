// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "recognition/camera.hpp"
#include "render/random.hpp"

namespace trihedron::render {

/// A set of cameras around a table.
struct RigOptions {
  std::string name = "paper";  ///< "paper": 450 x 300 px, 0.49 mm per px, 600 mm from the table's
                               ///< centre; "hd": 1280 x 960 px, 0.33 mm per px, 700 mm
  bool orthographic = false;
  int cameras = 3;    ///< top, side, front, then oblique ones; at least 2
  double jitter = 1;  ///< how far the cameras stand from their nominal poses: 1 is 12 mm
                      ///< across and 3 mm along the line of sight, 1 degree of roll
  std::array<double, 5> distortion{};  ///< OpenCV's k1 k2 p1 p2 k3
};

/// The part of the world that a rig looks at.
struct Field {
  Eigen::Vector2d centre;     ///< on the table, world, mm
  Eigen::Vector2d half_size;  ///< mm
};

/// The field of a rig. Throws Error when there is no rig of that name.
Field rig_field(const std::string& name);

/// The rig's cameras. Throws Error when the name or the number of cameras is wrong.
std::vector<Camera> make_rig(const RigOptions& options, Random& random);

/// `camera` as an imperfect calibration would report it: rotated about its own centre (pinhole) or
/// shifted (orthographic) by normal errors that move image points by `error_px` (standard
/// deviation, each axis), and rolled by as much at the image's corner.
Camera miscalibrated(const Camera& camera, double error_px, Random& random);

}  // namespace trihedron::render
