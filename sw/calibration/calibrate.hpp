// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/board.hpp"
#include "calibration/shots.hpp"
#include "recognition/camera.hpp"

namespace trihedron {

struct CalibrateOptions {
  /// How many of OpenCV's k1 k2 p1 p2 k3 are estimated, the others are 0: 0, 1, 2, 4 or 5.
  int lens_terms = 4;
  /// The shot in which the board lies on the table: its plane is z = 0, its first corner the
  /// world's origin, x along its rows, z up. Empty: the world is the first camera's frame.
  std::string table_shot;
  double board_thickness_mm = 0;  ///< the table's top lies so far below the printed face
};

/// How well one image fits.
struct ShotResidual {
  int camera = 0;  ///< index
  std::string key;
  double rms_px = 0;  ///< distance of a found corner from where it should be
};

/// One standard deviation of what was estimated, from the residuals and their derivatives.
struct CameraUncertainty {
  double focal_px = 0;
  double position_mm = 0;   ///< of the camera's centre, seen from the first camera
  double rotation_rad = 0;  ///< likewise
};

struct Calibration {
  std::vector<Camera> cameras;
  std::vector<ShotResidual> residuals;
  std::vector<CameraUncertainty> uncertainty;
  double rms_px = 0;
};

/// Calibrates two or more cameras from images of one board: each camera by itself, then lenses,
/// camera poses and board poses together, so that the squared distances in all images are least.
///
/// Throws Error on sets that do not determine the cameras: fewer than three boards in a camera,
/// boards that are all parallel, cameras that no shot connects, a focal length that stays
/// uncertain by more than 2 %, or residuals above a pixel.
Calibration calibrate(const std::vector<CameraShots>& cameras, const Board& board,
                      const CalibrateOptions& options = {});

}  // namespace trihedron
