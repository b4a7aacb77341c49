// SPDX-License-Identifier: Apache-2.0
#include "calibration/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibration/adjustment.hpp"
#include "calibration/start_values.hpp"
#include "golden/error.hpp"

namespace trihedron {
namespace {

void check_options(const std::vector<CameraShots>& cameras, const CalibrateOptions& options) {
  if (cameras.size() < 2)
    throw Error(
        fmt::format("{} camera; expected the images of two cameras or more", cameras.size()));
  for (std::size_t a = 0; a < cameras.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (cameras[a].name == cameras[b].name)
        throw Error("two cameras are named " + cameras[a].name +
                    "; expected folders or patterns of different names");
  constexpr int kAllowed[] = {0, 1, 2, 4, 5};
  if (std::find(std::begin(kAllowed), std::end(kAllowed), options.lens_terms) == std::end(kAllowed))
    throw Error(fmt::format("lens terms: {}; expected 0, 1, 2, 4 or 5", options.lens_terms));
}

/// Per image, and over all of them.
void measure(const RigEstimate& rig, const std::vector<CameraShots>& cameras, const Board& board,
             Calibration& out) {
  const std::vector<Eigen::Vector3d> points = board_points(board);
  double all = 0;
  std::size_t corners = 0;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    for (const Shot& shot : cameras[c].shots) {
      if (shot.corners.empty()) continue;
      const Transform& world_from_board = rig.world_from_board.at(shot.key);
      double sum = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d found(shot.corners[i].x, shot.corners[i].y);
        sum += (rig.cameras[c].project(world_from_board * points[i]) - found).squaredNorm();
      }
      out.residuals.push_back(
          {static_cast<int>(c), shot.key, std::sqrt(sum / static_cast<double>(points.size()))});
      all += sum;
      corners += points.size();
    }
  }
  out.rms_px = std::sqrt(all / static_cast<double>(corners));
}

/// A found corner is off by a few tenths of a pixel; a pixel over a whole image says that something
/// else is wrong.
void check_residuals(const Calibration& calibration, const std::vector<CameraShots>& cameras) {
  constexpr double kLargest_px = 1;
  const auto worst = std::max_element(
      calibration.residuals.begin(), calibration.residuals.end(),
      [](const ShotResidual& a, const ShotResidual& b) { return a.rms_px < b.rms_px; });
  if (worst->rms_px <= kLargest_px) return;
  const CameraShots& camera = cameras[static_cast<std::size_t>(worst->camera)];
  const auto shot = std::find_if(camera.shots.begin(), camera.shots.end(),
                                 [&](const Shot& s) { return s.key == worst->key; });
  throw Error(
      fmt::format("{}: its corners are {:.2f} px off (all images: {:.2f} px); expected less "
                  "than {} px: did the board or a camera move between the shots of one "
                  "name, is the board bent, or is --board another one?",
                  shot->file.string(), worst->rms_px, calibration.rms_px, kLargest_px));
}

void check_focal_lengths(const Calibration& calibration) {
  constexpr double kLargest = 0.02;  // of the focal length: 2 % of every distance
  for (std::size_t c = 0; c < calibration.cameras.size(); ++c) {
    const Camera& camera = calibration.cameras[c];
    if (calibration.uncertainty[c].focal_px < kLargest * camera.K(0, 0)) continue;
    throw Error(
        fmt::format("camera {}: the focal length {:.0f} px is known to {:.0f} px only; "
                    "expected more boards, tilted by 30 degrees and nearer to the camera",
                    camera.view, camera.K(0, 0), calibration.uncertainty[c].focal_px));
  }
}

/// The table's frame (z up, away from it) from the board's (z into it).
Transform table_from_board(double thickness_mm) {
  Transform out;
  out.R.diagonal() << 1, -1, -1;
  out.t.z() = thickness_mm;
  return out;
}

void set_world(const RigEstimate& rig, const CalibrateOptions& options, Calibration& out) {
  if (options.table_shot.empty()) return;
  const auto found = rig.world_from_board.find(options.table_shot);
  if (found == rig.world_from_board.end()) {
    std::string shots;
    for (const auto& entry : rig.world_from_board) shots += " " + entry.first;
    throw Error("--table: no board in a shot named " + options.table_shot + "; there are" + shots);
  }
  const Transform first_from_table =
      found->second * table_from_board(options.board_thickness_mm).inverse();
  for (Camera& camera : out.cameras)
    camera.camera_from_world = camera.camera_from_world * first_from_table;
}

}  // namespace

Calibration calibrate(const std::vector<CameraShots>& cameras, const Board& board,
                      const CalibrateOptions& options) {
  check_options(cameras, options);
  RigEstimate rig = start_values(cameras, board, options);
  Calibration out;
  out.uncertainty = adjust(rig, cameras, board, options);
  out.cameras = rig.cameras;
  measure(rig, cameras, board, out);
  check_residuals(out, cameras);
  check_focal_lengths(out);
  set_world(rig, options, out);
  return out;
}

}  // namespace trihedron
