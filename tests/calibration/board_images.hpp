// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "calibration/board.hpp"
#include "recognition/camera.hpp"

namespace trihedron {

/// Pictures of a board by one camera: exact rays, 3 x 3 samples a pixel, blur and noise as a mild
/// industrial camera has them.
class BoardImages {
 public:
  explicit BoardImages(const Camera& camera) : camera_(camera) {
    for (int y = 0; y < camera.height_px * kSamples; ++y)
      for (int x = 0; x < camera.width_px * kSamples; ++x)
        rays_.push_back(
            camera.ray({(x + 0.5) / kSamples - 0.5, (y + 0.5) / kSamples - 0.5}).direction);
  }

  cv::Mat picture(const Board& board, const Transform& world_from_board,
                  std::mt19937& random) const {
    const Transform board_from_world = world_from_board.inverse();
    const Eigen::Vector3d origin = board_from_world * camera_.camera_from_world.inverse().t;
    cv::Mat fine(camera_.height_px * kSamples, camera_.width_px * kSamples, CV_32F), small;
    for (int y = 0, i = 0; y < fine.rows; ++y)
      for (int x = 0; x < fine.cols; ++x, ++i) {
        const Eigen::Vector3d direction = board_from_world.R * rays_[static_cast<std::size_t>(i)];
        const double s = -origin.z() / direction.z();
        const Eigen::Vector3d hit = (origin + s * direction) / board.square_mm;
        fine.at<float>(y, x) = s > 0 && origin.z() < 0 ? grey(board, hit.x(), hit.y()) : kTable;
      }
    cv::resize(fine, small, {camera_.width_px, camera_.height_px}, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(small, small, {}, 0.6);
    std::normal_distribution<float> noise(0, 1.5f);
    cv::Mat out(small.size(), CV_8U);
    for (int y = 0; y < out.rows; ++y)
      for (int x = 0; x < out.cols; ++x)
        out.at<std::uint8_t>(y, x) =
            cv::saturate_cast<std::uint8_t>(small.at<float>(y, x) + noise(random));
    return out;
  }

 private:
  static constexpr int kSamples = 3;
  static constexpr float kTable = 90, kDark = 40, kLight = 210;

  /// In squares from the first inner corner: the checkers and a light border one square wide.
  static float grey(const Board& board, double x, double y) {
    if (x < -2 || y < -2 || x > board.columns + 1 || y > board.rows + 1) return kTable;
    if (x < -1 || y < -1 || x > board.columns || y > board.rows) return kLight;
    const int parity = static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y));
    return parity % 2 == 0 ? kDark : kLight;
  }

  Camera camera_;
  std::vector<Eigen::Vector3d> rays_;  ///< per sample, world
};

/// A camera that looks from `position` at `target`, its image's x axis level.
inline Camera looking(const std::string& name, const Eigen::Vector3d& position,
                      const Eigen::Vector3d& target, const Eigen::Vector3d& up) {
  Camera camera;
  camera.view = name;
  camera.width_px = 480;
  camera.height_px = 360;
  camera.K << 700, 0, 243, 0, 702, 176, 0, 0, 1;
  camera.distortion = {-0.12, 0.08, 0.0008, -0.0005, 0};
  const Eigen::Vector3d z = (target - position).normalized(), x = z.cross(up).normalized();
  camera.camera_from_world.R << x.transpose(), z.cross(x).transpose(), z.transpose();
  camera.camera_from_world.t = -(camera.camera_from_world.R * position);
  return camera;
}

/// A board whose middle lies at `middle` and whose face looks along `facing`, turned by `roll_rad`.
inline Transform board_at(const Board& board, const Eigen::Vector3d& middle,
                          const Eigen::Vector3d& facing, double roll_rad) {
  const Eigen::Vector3d z = -facing.normalized();
  const Eigen::Vector3d x0 = z.unitOrthogonal();
  const Eigen::Vector3d x = std::cos(roll_rad) * x0 + std::sin(roll_rad) * z.cross(x0);
  Transform out;
  out.R << x, z.cross(x), z;
  out.t = middle - out.R * Eigen::Vector3d((board.columns - 1) * board.square_mm / 2,
                                           (board.rows - 1) * board.square_mm / 2, 0);
  return out;
}

}  // namespace trihedron
