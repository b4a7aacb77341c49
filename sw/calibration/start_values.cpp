// SPDX-License-Identifier: Apache-2.0
#include "calibration/start_values.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <optional>

#include "golden/error.hpp"

namespace trihedron {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180;

/// One camera by itself.
struct Single {
  Camera camera;
  std::map<std::string, Transform> camera_from_board;  ///< by shot
};

std::vector<const Shot*> boards_of(const CameraShots& camera) {
  std::vector<const Shot*> out;
  for (const Shot& shot : camera.shots)
    if (!shot.corners.empty()) out.push_back(&shot);
  return out;
}

void check_number(const CameraShots& camera, std::size_t boards) {
  constexpr std::size_t kLeast = 3;  // two unknowns of a lens each, and one to spare
  if (boards >= kLeast) return;
  std::string missing;
  for (const Shot& shot : camera.shots)
    if (shot.corners.empty())
      missing += (missing.empty() ? "" : ", ") + shot.file.filename().string();
  throw Error(
      fmt::format("camera {}: {} board{} found in {} images{}; expected the whole board, sharp "
                  "and with a white border, in 3 images at least, better 10",
                  camera.name, boards, boards == 1 ? "" : "s", camera.shots.size(),
                  missing.empty() ? "" : " (none in " + missing + ")"));
}

/// A board's normal in the frame of a nominal camera, from its vanishing line alone: parallel
/// boards give equal normals whatever the lens.
Vector3d nominal_normal(const Shot& shot, const std::vector<cv::Point3f>& points, cv::Size size) {
  std::vector<cv::Point2f> on_board, in_image;
  const float focal = static_cast<float>(std::max(size.width, size.height));
  const cv::Point2f middle(static_cast<float>(size.width) / 2, static_cast<float>(size.height) / 2);
  for (const cv::Point3f& p : points) on_board.emplace_back(p.x, p.y);
  for (const cv::Point2f& p : shot.corners) in_image.push_back((p - middle) / focal);
  Matrix3d image_from_board;
  cv::cv2eigen(cv::findHomography(on_board, in_image), image_from_board);
  return (image_from_board.inverse().transpose() * Vector3d::UnitZ()).normalized();
}

/// Parallel boards leave the focal length open: a near scene and a far one look alike.
void check_tilts(const CameraShots& camera, const std::vector<const Shot*>& boards,
                 const std::vector<cv::Point3f>& points) {
  double widest = 0;
  for (const Shot* a : boards)
    for (const Shot* b : boards) {
      const double cosine = std::abs(
          nominal_normal(*a, points, camera.size).dot(nominal_normal(*b, points, camera.size)));
      widest = std::max(widest, std::acos(std::min(1.0, cosine)));
    }
  constexpr double kLeast =
      8 * kDegree;  // below it the focal length is known to a few percent only
  if (widest < kLeast)
    throw Error(
        fmt::format("camera {}: its {} boards are parallel within {:.1f} degrees; expected "
                    "boards tilted against each other, by 30 degrees or more",
                    camera.name, boards.size(), widest / kDegree));
}

int lens_flags(int terms) {
  int flags = 0;
  if (terms < 5) flags |= cv::CALIB_FIX_K3;
  if (terms < 4) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  if (terms < 2) flags |= cv::CALIB_FIX_K2;
  if (terms < 1) flags |= cv::CALIB_FIX_K1;
  return flags;
}

Transform to_transform(const cv::Mat& rotation_vector, const cv::Mat& translation) {
  cv::Mat rotation;
  cv::Rodrigues(rotation_vector, rotation);
  Transform out;
  cv::cv2eigen(rotation, out.R);
  cv::cv2eigen(translation, out.t);
  return out;
}

Single calibrate_single(const CameraShots& shots, const Board& board, int lens_terms) {
  const std::vector<const Shot*> boards = boards_of(shots);
  check_number(shots, boards.size());
  std::vector<cv::Point3f> points;
  for (const Vector3d& p : board_points(board))
    points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.f);
  check_tilts(shots, boards, points);
  std::vector<std::vector<cv::Point2f>> corners;
  for (const Shot* shot : boards) corners.push_back(shot->corners);
  cv::Mat K, lens;
  std::vector<cv::Mat> rotations, translations;
  cv::calibrateCamera(std::vector(boards.size(), points), corners, shots.size, K, lens, rotations,
                      translations, lens_flags(lens_terms));
  Single out;
  cv::cv2eigen(K, out.camera.K);
  for (int i = 0; i < 5; ++i)
    out.camera.distortion[static_cast<std::size_t>(i)] = lens.at<double>(i);
  out.camera.view = shots.name;
  out.camera.width_px = shots.size.width;
  out.camera.height_px = shots.size.height;
  for (std::size_t i = 0; i < boards.size(); ++i)
    out.camera_from_board[boards[i]->key] = to_transform(rotations[i], translations[i]);
  return out;
}

/// The motion b_from_a of two cameras: of the proposals of their common shots the one that the
/// others agree with most. Nothing without a common shot.
std::optional<Transform> relative(const Single& a, const Single& b, std::size_t& shared) {
  std::vector<Transform> proposals;
  for (const auto& [key, a_from_board] : a.camera_from_board)
    if (const auto found = b.camera_from_board.find(key); found != b.camera_from_board.end())
      proposals.push_back(found->second * a_from_board.inverse());
  shared = proposals.size();
  std::optional<Transform> best;
  double least = 0;
  for (const Transform& p : proposals) {
    double sum = 0;  // of the angles between the rotations, and of the shifts per distance
    for (const Transform& q : proposals)
      sum += Eigen::AngleAxisd(p.R.transpose() * q.R).angle() +
             (p.t - q.t).norm() / std::max(1.0, p.t.norm());
    if (!best || sum < least) {
      best = p;
      least = sum;
    }
  }
  return best;
}

/// Adds the camera that shares most shots with those placed so far; false when none is left over.
bool place_next(std::vector<Single>& singles, std::vector<bool>& placed) {
  std::size_t most = 0, next = 0;
  Transform pose;
  std::string left;
  for (std::size_t b = 0; b < singles.size(); ++b) {
    if (placed[b]) continue;
    left = singles[b].camera.view;
    for (std::size_t a = 0; a < singles.size(); ++a) {
      std::size_t shared = 0;
      if (!placed[a]) continue;
      const auto b_from_a = relative(singles[a], singles[b], shared);
      if (shared <= most) continue;
      most = shared;
      next = b;
      pose = *b_from_a * singles[a].camera.camera_from_world;
    }
  }
  if (left.empty()) return false;
  if (most == 0)
    throw Error("camera " + left +
                ": shares no shot with the other cameras; expected images of equal names in which "
                "two cameras see the whole board at once");
  singles[next].camera.camera_from_world = pose;
  placed[next] = true;
  return true;
}

}  // namespace

RigEstimate start_values(const std::vector<CameraShots>& cameras, const Board& board,
                         const CalibrateOptions& options) {
  std::vector<Single> singles;
  for (const CameraShots& camera : cameras)
    singles.push_back(calibrate_single(camera, board, options.lens_terms));
  std::vector<bool> placed(singles.size());
  placed[0] = true;
  while (place_next(singles, placed)) {
  }
  RigEstimate rig;
  for (const Single& single : singles) {
    rig.cameras.push_back(single.camera);
    const Transform world_from_camera = single.camera.camera_from_world.inverse();
    for (const auto& [key, camera_from_board] : single.camera_from_board)
      rig.world_from_board.emplace(key, world_from_camera * camera_from_board);
  }
  return rig;
}

}  // namespace trihedron
