// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "calibration/board.hpp"

namespace trihedron {

/// One image of a calibration.
struct Shot {
  std::string key;  ///< equal in images of all cameras that were taken together
  std::filesystem::path file;
  std::vector<cv::Point2f> corners;  ///< px; empty: no board found
};

/// The images of one camera.
struct CameraShots {
  std::string name;
  cv::Size size;  ///< px
  std::vector<Shot> shots;
};

/// The images of `source`: a folder, or a pattern with one * in the file name ("left*.jpg"), with
/// the boards found in them. A shot's key is the file's name without ending, or what stands for
/// the *. Throws Error when there is no image, one cannot be read, or sizes differ.
CameraShots read_shots(const std::string& source, const Board& board);

}  // namespace trihedron
