// SPDX-License-Identifier: Apache-2.0
#include "recognition/camera.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>
#include <random>

using namespace trihedron;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kRoundingPx = 1e-9;  // double arithmetic on pixel numbers below 1e4

Camera pinhole() {
  Camera camera;
  camera.K << 1228.4, 0.7, 224.5, 0, 1190.1, 149.5, 0, 0, 1;
  camera.distortion = {-0.21, 0.13, 0.0012, -0.0007, 0.05};
  camera.camera_from_world.R =
      (Eigen::AngleAxisd(3.0, Vector3d::UnitX()) * Eigen::AngleAxisd(0.2, Vector3d::UnitY()))
          .toRotationMatrix();
  camera.camera_from_world.t = {-110, 73, 600};
  camera.width_px = 450;
  camera.height_px = 300;
  return camera;
}

Camera orthographic() {
  Camera camera = pinhole();
  camera.projection = Camera::Projection::kOrthographic;
  camera.px_per_mm = 2.0473;
  return camera;
}

/// Distance in mm of a point from a ray.
double distance(const Ray& ray, const Vector3d& x) {
  return (x - ray.origin).cross(ray.direction).norm();
}

}  // namespace

TEST_CASE("a pinhole camera projects as OpenCV does") {
  Camera camera = pinhole();
  camera.K(0, 1) = 0;  // OpenCV knows no skew
  std::mt19937 random(1);
  std::uniform_real_distribution<double> position(-90, 90);
  const cv::Matx33d K(camera.K(0, 0), 0, camera.K(0, 2), 0, camera.K(1, 1), camera.K(1, 2), 0, 0,
                      1);
  const std::vector<double> lens(camera.distortion.begin(), camera.distortion.end());
  for (int i = 0; i < 200; ++i) {
    const Vector3d x(position(random), position(random), 600 + position(random));
    std::vector<cv::Point2d> expected;
    cv::projectPoints(std::vector<cv::Point3d>{{x.x(), x.y(), x.z()}}, cv::Vec3d(), cv::Vec3d(), K,
                      lens, expected);
    const Vector2d got = camera.project_camera(x);
    REQUIRE(got.x() == Approx(expected[0].x).margin(kRoundingPx));
    REQUIRE(got.y() == Approx(expected[0].y).margin(kRoundingPx));
  }
}

TEST_CASE("an orthographic camera scales and shifts, whatever the depth") {
  const Camera camera = orthographic();
  const Vector2d near = camera.project_camera({10, -20, 100});
  CHECK(near.x() == Approx(2.0473 * 10 + 224.5));
  CHECK(near.y() == Approx(2.0473 * -20 + 149.5));
  CHECK((camera.project_camera({10, -20, 900}) - near).norm() == 0);
}

TEST_CASE("the ray of a pixel passes through every point that projects there") {
  for (const Camera& camera : {pinhole(), orthographic()}) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> position(-60, 60);
    for (int i = 0; i < 200; ++i) {
      const Vector3d x(110 + position(random), 73 + position(random), position(random));
      const Ray ray = camera.ray(camera.project(x));
      REQUIRE(ray.direction.norm() == Approx(1));
      REQUIRE((x - ray.origin).dot(ray.direction) > 0);
      constexpr double kBoundMm = 1e-8;  // kRoundingPx at the lens's steepest, 1 px/mm
      REQUIRE(distance(ray, x) < kBoundMm);
    }
  }
}

TEST_CASE("undistorting gives the pixel of the same camera without its lens") {
  const Camera camera = pinhole();
  Camera ideal = camera;
  ideal.distortion = {};
  const Vector3d x(150, 20, 12);
  CHECK((camera.project(x) - ideal.project(x)).norm() > 0.1);
  CHECK((camera.undistort(camera.project(x)) - ideal.project(x)).norm() < 1e-8);
  CHECK((orthographic().undistort({3, 4}) - Vector2d(3, 4)).norm() == 0);
}

TEST_CASE("px per mm is the motion in the image of a point that moves by one mm") {
  for (Camera camera : {pinhole(), orthographic()}) {
    camera.distortion = {};
    camera.K(0, 1) = 0;
    camera.K(1, 1) = camera.K(0, 0);
    const Vector3d x(120, 60, 20);
    const double expected =
        (camera.project(x + camera.camera_from_world.R.row(0).transpose()) - camera.project(x))
            .norm();
    CHECK(camera.px_per_mm_at(x) == Approx(expected));
  }
}
