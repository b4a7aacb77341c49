// SPDX-License-Identifier: Apache-2.0
#include "recognition/rig_accuracy.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace trihedron;
using Eigen::Vector3d;

namespace {

constexpr double kFocal = 1200, kDistance = 600;

/// A camera that looks at the origin from direction `from`.
Camera camera_from(const Vector3d& from) {
  Camera camera;
  camera.width_px = camera.height_px = 401;
  camera.K << kFocal, 0, 200, 0, kFocal, 200, 0, 0, 1;
  const Vector3d z = -from.normalized(), x = z.unitOrthogonal();
  camera.camera_from_world.R << x.transpose(), z.cross(x).transpose(), z.transpose();
  camera.camera_from_world.t = {0, 0, kDistance};
  return camera;
}

}  // namespace

TEST_CASE("two cameras at an angle have the accuracy of the textbook") {
  const double noise = 0.3, mm_per_px = kDistance / kFocal;
  for (const double angle : {0.2, 0.8, 1.5}) {
    const std::vector<Camera> cameras = {
        camera_from({std::sin(angle / 2), 0, std::cos(angle / 2)}),
        camera_from({-std::sin(angle / 2), 0, std::cos(angle / 2)})};
    const PointAccuracy accuracy = point_accuracy(cameras, Vector3d::Zero(), noise);
    CHECK(accuracy.views == 2);
    CHECK(accuracy.worst_mm ==
          Approx(noise * mm_per_px / (std::sqrt(2) * std::sin(angle / 2))));  // along the bisector
    CHECK(std::abs(accuracy.worst_axis.z()) == Approx(1));
    CHECK(accuracy.best_mm == Approx(noise * mm_per_px / std::sqrt(2)));
    CHECK(widest_angle(cameras, Vector3d::Zero()) == Approx(angle));
    CHECK(rig_centre(cameras).norm() < 1e-9);
  }
}

TEST_CASE("three cameras at right angles are equally good in every direction") {
  const std::vector<Camera> cameras = {camera_from({0, 0, 1}), camera_from({0, -1, 0}),
                                       camera_from({1, 0, 0})};
  const PointAccuracy accuracy = point_accuracy(cameras, Vector3d::Zero(), 0.2);
  CHECK(accuracy.views == 3);
  CHECK(accuracy.best_mm == Approx(0.2 * kDistance / kFocal / std::sqrt(2)));
  CHECK(accuracy.worst_mm == Approx(accuracy.best_mm));
}

TEST_CASE("points located from noisy images scatter as predicted") {
  std::mt19937 random(7);
  const double noise = 0.4;
  std::normal_distribution<double> error(0, noise);
  std::vector<Camera> cameras = {camera_from({0.2, 0.1, 1}), camera_from({0.9, -0.6, 0.5})};
  cameras[0].distortion = {-0.2, 0.05, 0.001, 0, 0};
  const Vector3d truth(20, -15, 10);
  const PointAccuracy predicted = point_accuracy(cameras, truth, noise);
  constexpr int kTrials = 4000;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    // One Gauss-Newton step from the truth: the errors are small against the curvature.
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Camera& camera : cameras) {
      const auto J = camera.projection_jacobian(truth);
      normal += J.transpose() * J;
      right += J.transpose() * Eigen::Vector2d(error(random), error(random));
    }
    const Vector3d located = truth + normal.ldlt().solve(right);
    for (const Camera& camera : cameras)  // the step is one: what is left is orthogonal to it
      REQUIRE((camera.project(located) - camera.project(truth)).norm() < 20 * noise);
    scatter += (located - truth) * (located - truth).transpose() / kTrials;
  }
  constexpr double kSampling = 0.1;  // four times sqrt(2 / trials)
  CHECK((scatter - predicted.covariance_mm2).norm() < kSampling * predicted.covariance_mm2.norm());
}

TEST_CASE("a point that fewer than two cameras see has no accuracy") {
  const std::vector<Camera> cameras = {camera_from({0, 0, 1}), camera_from({1, 0, 0})};
  const PointAccuracy outside = point_accuracy(cameras, {0, 0, 200}, 0.2);
  CHECK(outside.views == 1);
  CHECK(outside.worst_mm == 0);
}
