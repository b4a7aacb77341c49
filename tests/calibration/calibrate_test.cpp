// SPDX-License-Identifier: Apache-2.0
#include "calibration/calibrate.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "calibration/board_images.hpp"
#include "golden/error.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using Eigen::Vector3d;

namespace {

const Board kBoard{9, 6, 15};
const Vector3d kMiddle(110, 70, 40);

std::vector<Camera> three_cameras() {
  return {looking("top", {110, 70, 700}, kMiddle, {0, 1, 0}),
          looking("side", {115, -600, 60}, kMiddle, {0, 0, 1}),
          looking("front", {760, 80, 50}, kMiddle, {0, 0, 1})};
}

/// Boards that look between the cameras, so that all three see them, and at each of them.
std::vector<Transform> board_poses(std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-25, 25), tilt(-0.2, 0.2), roll(-3, 3);
  const Vector3d facings[] = {{1, -1, 1}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0}};
  std::vector<Transform> out;
  for (int i = 0; i < 11; ++i) {
    const Vector3d facing = facings[i < 8 ? 0 : 1 + i % 3].normalized();
    out.push_back(board_at(kBoard, kMiddle + Vector3d(shift(random), shift(random), shift(random)),
                           facing + Vector3d(tilt(random), tilt(random), tilt(random)),
                           roll(random)));
  }
  return out;
}

/// Whether the camera sees the board's face, at less than 70 degrees.
bool faces(const Camera& camera, const Transform& world_from_board) {
  const Vector3d to_camera = camera.camera_from_world.inverse().t - world_from_board.t;
  return -world_from_board.R.col(2).dot(to_camera.normalized()) > 0.34;
}

/// The shots that `cameras` would take of the boards that face them.
std::vector<CameraShots> take(const std::vector<Camera>& cameras,
                              const std::vector<Transform>& boards, std::mt19937& random) {
  std::vector<CameraShots> out;
  for (const Camera& camera : cameras) {
    const BoardImages images(camera);
    CameraShots shots{camera.view, {camera.width_px, camera.height_px}, {}};
    for (std::size_t b = 0; b < boards.size(); ++b) {
      if (!faces(camera, boards[b])) continue;
      const std::string key = std::to_string(100 + b);
      shots.shots.push_back({key, camera.view + key + ".png",
                             find_board(images.picture(kBoard, boards[b], random), kBoard)});
    }
    out.push_back(shots);
  }
  return out;
}

/// Shots without pictures: corners where the true cameras see them.
std::vector<CameraShots> exact(const std::vector<Camera>& cameras,
                               const std::vector<Transform>& boards) {
  std::vector<CameraShots> out;
  for (const Camera& camera : cameras) {
    CameraShots shots{camera.view, {camera.width_px, camera.height_px}, {}};
    for (std::size_t b = 0; b < boards.size(); ++b) {
      Shot shot{std::to_string(100 + b), camera.view + std::to_string(100 + b) + ".png", {}};
      for (const Vector3d& x : board_points(kBoard)) {
        const Eigen::Vector2d p = camera.project(boards[b] * x);
        shot.corners.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
      }
      shots.shots.push_back(shot);
    }
    out.push_back(shots);
  }
  return out;
}

/// Where `estimated` cameras locate a point that the `true` ones see: nearest to all rays.
Vector3d located(const std::vector<Camera>& truth, const std::vector<Camera>& estimated,
                 const Vector3d& x) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t c = 0; c < truth.size(); ++c) {
    const Ray ray = estimated[c].ray(truth[c].project(x));
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    normal += across;
    right += across * ray.origin;
  }
  return normal.ldlt().solve(right);
}

std::string refusal(const std::vector<CameraShots>& shots) {
  return error_of([&] { calibrate(shots, kBoard); });
}

}  // namespace

TEST_CASE("corners are found to a tenth of a pixel, the same one first in every view") {
  std::mt19937 random(1);
  const std::vector<Camera> cameras = three_cameras();
  const std::vector<Transform> boards = board_poses(random);
  const std::vector<CameraShots> shots = take(cameras, boards, random),
                                 truth = exact(cameras, boards);
  int found = 0;
  double squares = 0;
  for (std::size_t c = 0; c < shots.size(); ++c)
    for (const Shot& shot : shots[c].shots) {
      const auto& corners = shot.corners;
      const auto& right = truth[c].shots[std::stoul(shot.key) - 100].corners;
      if (corners.empty()) continue;
      ++found;
      for (std::size_t i = 0; i < corners.size(); ++i)
        squares += std::pow(cv::norm(corners[i] - right[i]), 2);
    }
  CHECK(found >= 25);  // 8 boards in three views, 3 in one each; two may be cut off
  const double rms = std::sqrt(squares / (found * 54));
  INFO("found " << found << ", rms " << rms << " px");
  CHECK(rms < 0.1);
}

TEST_CASE("a rig is calibrated from pictures as exactly as it says") {
  std::mt19937 random(2);
  const std::vector<Camera> truth = three_cameras();
  const std::vector<CameraShots> shots = take(truth, board_poses(random), random);
  const Calibration result = calibrate(shots, kBoard);
  CHECK(result.rms_px < 0.15);  // corners are found to a tenth of a pixel
  const Transform truth_from_result =
      truth[0].camera_from_world.inverse() * result.cameras[0].camera_from_world;
  constexpr double kSigmas = 4;  // one in 16000 is farther off, were the errors normal
  for (std::size_t c = 0; c < truth.size(); ++c) {
    const Camera& camera = result.cameras[c];
    const CameraUncertainty& sd = result.uncertainty[c];
    INFO(camera.view << ": focal length " << camera.K(0, 0) << " +- " << sd.focal_px
                     << " px, position +- " << sd.position_mm << " mm");
    CHECK(std::abs(camera.K(0, 0) - truth[c].K(0, 0)) < kSigmas * sd.focal_px);
    CHECK(std::abs(camera.K(1, 1) - truth[c].K(1, 1)) < kSigmas * sd.focal_px);
    CHECK(sd.focal_px < 3);
    const Transform error =
        truth[c].camera_from_world * truth_from_result * camera.camera_from_world.inverse();
    const Vector3d shift = truth_from_result * camera.camera_from_world.inverse().t -
                           truth[c].camera_from_world.inverse().t;
    CHECK(shift.norm() <= kSigmas * sd.position_mm + 1e-9);
    CHECK(Eigen::AngleAxisd(error.R).angle() <= kSigmas * sd.rotation_rad + 1e-7);
  }
  // What counts for recognition: lengths between points that the calibrated rig locates.
  constexpr double kScale = 0.001;
  const std::vector<Vector3d> ends = {{60, 30, 10}, {160, 30, 10}, {110, 120, 10}, {110, 70, 90}};
  for (const Vector3d& a : ends)
    for (const Vector3d& b : ends) {
      const double length =
          (located(truth, result.cameras, a) - located(truth, result.cameras, b)).norm();
      CHECK(length == Approx((a - b).norm()).epsilon(kScale).margin(1e-9));
    }
}

TEST_CASE("exact corners give back the rig, in the table's frame too") {
  std::mt19937 random(3);
  const std::vector<Camera> truth = three_cameras();
  std::vector<Transform> boards = board_poses(random);
  boards[0] = board_at(kBoard, {110, 70, 5}, {0, 0, 1}, 0.3);  // flat, 5 mm thick
  CalibrateOptions options;
  options.table_shot = "100";
  options.board_thickness_mm = 5;
  const Calibration result = calibrate(exact(truth, boards), kBoard, options);
  constexpr double kFloat_mm = 0.01, kFloat_px = 0.01;  // corners are stored in single precision
  CHECK(result.rms_px < 1e-4);
  for (std::size_t c = 0; c < truth.size(); ++c) {
    CHECK((result.cameras[c].K - truth[c].K).cwiseAbs().maxCoeff() < kFloat_px);
    for (std::size_t i = 0; i < 5; ++i)
      CHECK(result.cameras[c].distortion[i] == Approx(truth[c].distortion[i]).margin(1e-3));
  }
  for (const Vector3d& corner : board_points(kBoard)) {  // the table's points are at height 0
    const Vector3d on_board = boards[0] * corner;
    const Vector3d world(corner.x(), -corner.y(), 5);
    for (std::size_t c = 0; c < truth.size(); ++c)
      CHECK((result.cameras[c].camera_from_world * world - truth[c].camera_from_world * on_board)
                .norm() < kFloat_mm);
  }
}

TEST_CASE("sets that do not determine the cameras are refused with what is missing") {
  std::mt19937 random(4);
  const std::vector<Camera> cameras = three_cameras();
  const std::vector<Transform> boards = board_poses(random);
  std::vector<CameraShots> shots = exact(cameras, boards);
  SECTION("too few boards") {
    for (std::size_t s = 2; s < shots[1].shots.size(); ++s) shots[1].shots[s].corners.clear();
    CHECK_THAT(refusal(shots),
               Contains("camera side: 2 boards found in 11 images (none in side102") &&
                   Contains("3 images at least"));
  }
  SECTION("parallel boards") {
    std::vector<Transform> flat;
    for (int i = 0; i < 5; ++i)
      flat.push_back(board_at(kBoard, {100.0 + 5 * i, 70, 10.0 * i}, {0.3, -0.2, 1}, 0.4 * i));
    CHECK_THAT(refusal(exact(cameras, flat)), Contains("boards are parallel within 0."));
  }
  SECTION("no common shot") {
    for (std::size_t s = 0; s < 11; ++s) shots[s < 7 ? 1 : 2].shots[s].corners.clear();
    for (std::size_t s = 7; s < 11; ++s) shots[0].shots[s].corners.clear();
    CHECK_THAT(refusal(shots), Contains("camera side: shares no shot with the other cameras"));
  }
  SECTION("a board that moved between two cameras' shots") {
    std::vector<Transform> moved = boards;
    moved[3].t += Vector3d(0, 4, 0);
    shots[2].shots[3] = exact(cameras, moved)[2].shots[3];
    CHECK_THAT(refusal(shots), Contains("103.png: its corners are") && Contains("did the board"));
  }
  SECTION("another board") {
    for (CameraShots& camera : shots)
      for (Shot& shot : camera.shots) std::reverse(shot.corners.begin() + 9, shot.corners.end());
    CHECK(refusal(shots) != "no error");
  }
  SECTION("one camera") {
    shots.resize(1);
    CHECK_THAT(refusal(shots), Contains("two cameras or more"));
  }
  SECTION("an unknown table") {
    CHECK_THAT(error_of([&] {
                 CalibrateOptions options;
                 options.table_shot = "7";
                 calibrate(shots, kBoard, options);
               }),
               Contains("--table: no board in a shot named 7; there are 100 101"));
  }
}

TEST_CASE("boards on which cameras cannot agree, and senseless ones, are refused") {
  CHECK_THAT(error_of([] { parse_board("8x6", 20); }), Contains("half turn") && Contains("9x6"));
  CHECK_THAT(error_of([] { parse_board("9 by 6", 20); }), Contains("such as 9x6"));
  CHECK_THAT(error_of([] { parse_board("2x9", 20); }), Contains("3 to 100"));
  CHECK(parse_board("9x6", 20).columns == 9);
}
