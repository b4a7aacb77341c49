// SPDX-License-Identifier: Apache-2.0
#include "recognition/refinement.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

double vertex_error(const Model& model, const Transform& a, const Transform& b) {
  double sum = 0;
  for (const Vector3d& v : model.mesh.vertices) sum += (a * v - b * v).norm();
  return sum / static_cast<double>(model.mesh.vertices.size());
}

Vector6d random_motion(std::mt19937& random, double angle_rad, double distance_mm) {
  std::normal_distribution<double> n;
  Vector3d a(n(random), n(random), n(random)), b(n(random), n(random), n(random));
  Vector6d out;
  out << angle_rad * a.normalized(), distance_mm * b.normalized();
  return out;
}

}  // namespace

TEST_CASE("the motion Jacobian agrees with central differences") {
  constexpr double kStep = 1e-4;
  // Truncation of order step^2 times a curvature below 10 px per unit^3, and rounding.
  constexpr double kTolerancePx = 1e-5;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-40, 40);
  auto cameras = rigs::three_views();
  cameras.push_back(rigs::three_views(false)[1]);
  cameras[1].distortion = {-0.2, 0.1, 0.001, -0.002, 0.05};
  for (const Camera& camera : cameras) {
    const Transform pose = rigs::pose({0.4, -0.3, 0.9}, {5, -8, 30});
    const Vector3d x_in_model(u(random), u(random), u(random));
    const auto jacobian = motion_jacobian(camera, pose * x_in_model, pose.t);
    for (int i = 0; i < 6; ++i) {
      Vector6d motion = Vector6d::Zero();
      motion[i] = kStep;
      const Eigen::Vector2d numeric = (camera.project(moved(pose, motion) * x_in_model) -
                                       camera.project(moved(pose, -motion) * x_in_model)) /
                                      (2 * kStep);
      CHECK((numeric - jacobian.col(i)).norm() < kTolerancePx * (1 + numeric.norm()));
    }
  }
}

TEST_CASE("refinement finds the pose from 5 mm and 5 degrees away") {
  // 16 samples a pixel place an edge to a few hundredths of a pixel of 0.49 mm.
  constexpr double kTolerance = 0.1;  // mm, mean over vertices
  const Model models[] = {rigs::l_bracket(), rigs::block(60, 50, 40)};
  std::mt19937 random(5);
  for (const Model& model : models) {
    for (bool pinhole : {true, false}) {
      const auto cameras = rigs::three_views(pinhole);
      const Transform truth = rigs::pose({0.1, 0.05, 0.6}, {-5, 4, 30});
      std::vector<ViewFeatures> features;
      for (const Camera& c : cameras) features.push_back(rigs::features_of(c, {{&model, truth}}));
      std::vector<ContourField> fields(features.begin(), features.end());
      std::vector<FieldView> views;
      for (std::size_t v = 0; v < 3; ++v) views.push_back({&cameras[v], &fields[v]});
      const Transform start = moved(truth, random_motion(random, 5 * M_PI / 180, 5));
      const RefinedPose refined = refine(views, {{&model, start}}, 0);
      INFO(model.name << (pinhole ? " pinhole" : " orthographic"));
      CHECK(refined.converged);
      CHECK(vertex_error(model, refined.world_from_model, truth) < kTolerance);
      CHECK(refined.rms_px < 0.5);
      CHECK(std::abs(refined.world_from_model.R.determinant() - 1) < 1e-9);
      // Not a guess: the stated deviation covers the error, and is not absurdly wide.
      const double sigma = std::sqrt(refined.covariance.bottomRightCorner<3, 3>().trace());
      CHECK((refined.world_from_model.t - truth.t).norm() < 5 * sigma);
      CHECK(sigma < 0.3);
    }
  }
}

TEST_CASE("an exact edge position does not depend on where the edge falls in its pixel") {
  constexpr double kTolerancePx = 0.05;
  for (int tenth = 0; tenth < 10; ++tenth) {
    const double edge = 30 + 0.1 * tenth;  // the step lies at this x, pixels are areas
    std::vector<std::uint8_t> grey;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 64; ++x) {
        const double share = std::clamp(x + 0.5 - edge, 0.0, 1.0);
        grey.push_back(static_cast<std::uint8_t>(50 + 100 * share + 0.5));
      }
    }
    const ViewFeatures features = golden::run_front_end(grey.data(), 64, 40, 64);
    const ContourField field(features);
    const EdgeProfile profile = field.profile({30.3, 20}, {1, 0});
    CHECK(profile.offset_px == Approx(edge - 30.3).margin(kTolerancePx));
    CHECK(profile.height > 10 * profile.sigma_height);
    CHECK(field.nearest_contour({25, 20}, {1, 0}, 12) == Approx(edge - 25).margin(1.0));
    CHECK(std::isnan(field.nearest_contour({25, 20}, {0, 1}, 12)));
    CHECK(std::isnan(field.nearest_contour({10, 20}, {1, 0}, 12)));
  }
}
