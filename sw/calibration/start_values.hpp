// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "calibration/calibrate.hpp"

namespace trihedron {

/// A rig as far as it is known, in the frame of the first camera ("world" here).
struct RigEstimate {
  std::vector<Camera> cameras;
  std::map<std::string, Transform> world_from_board;  ///< by shot
};

/// Start values for the joint adjustment: each camera calibrated by itself, poses chained over the
/// shots that two cameras share, the pair with most of them first. Throws Error as calibrate()
/// does.
RigEstimate start_values(const std::vector<CameraShots>& cameras, const Board& board,
                         const CalibrateOptions& options);

}  // namespace trihedron
