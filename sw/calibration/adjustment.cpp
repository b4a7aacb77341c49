// SPDX-License-Identifier: Apache-2.0
#include "calibration/adjustment.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "golden/error.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;
using Lens = std::array<double, 9>;    // fx fy cx cy, k1 k2 p1 p2 k3
using Motion = std::array<double, 6>;  // rotation vector rad, translation mm

Motion to_motion(const Transform& transform) {
  const Eigen::AngleAxisd turn(transform.R);
  const Vector3d r = turn.angle() * turn.axis(), &t = transform.t;
  return {r.x(), r.y(), r.z(), t.x(), t.y(), t.z()};
}

Transform to_transform(const double* m) {
  const Vector3d r(m[0], m[1], m[2]);
  const double angle = r.norm();
  Transform out;
  if (angle > 0) out.R = Eigen::AngleAxisd(angle, r / angle).toRotationMatrix();
  out.t = {m[3], m[4], m[5]};
  return out;
}

Lens to_lens(const Camera& camera) {
  Lens out{camera.K(0, 0), camera.K(1, 1), camera.K(0, 2), camera.K(1, 2)};
  std::copy(camera.distortion.begin(), camera.distortion.end(), out.begin() + 4);
  return out;
}

void set_lens(Camera& camera, const double* lens) {
  camera.K << lens[0], 0, lens[2], 0, lens[1], lens[3], 0, 0, 1;
  std::copy(lens + 4, lens + 9, camera.distortion.begin());
}

/// The distances, px, of one image's corners from where lens, camera and board put them.
class ImageCost {
 public:
  ImageCost(const std::vector<Vector3d>& points, const std::vector<cv::Point2f>& corners)
      : points_(points), corners_(corners) {}

  bool operator()(double const* const* parameters, double* residuals) const {
    Camera camera;
    set_lens(camera, parameters[0]);
    const Transform camera_from_board = to_transform(parameters[1]) * to_transform(parameters[2]);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3d x = camera_from_board * points_[i];
      if (x.z() <= 0) return false;  // a step behind the camera: the solver takes a shorter one
      const Eigen::Vector2d pixel = camera.project_camera(x);
      residuals[2 * i] = pixel.x() - corners_[i].x;
      residuals[2 * i + 1] = pixel.y() - corners_[i].y;
    }
    return true;
  }

 private:
  const std::vector<Vector3d>& points_;
  const std::vector<cv::Point2f>& corners_;
};

struct Problem {
  std::vector<Lens> lenses;
  std::vector<Motion> poses;
  std::map<std::string, Motion> boards;
  std::vector<Vector3d> points;
  ceres::Problem ceres;
};

void build(Problem& problem, const RigEstimate& rig, const std::vector<CameraShots>& cameras,
           const Board& board, int lens_terms) {
  problem.points = board_points(board);
  for (const Camera& camera : rig.cameras) {
    problem.lenses.push_back(to_lens(camera));
    problem.poses.push_back(to_motion(camera.camera_from_world));
  }
  for (const auto& [key, pose] : rig.world_from_board) problem.boards[key] = to_motion(pose);
  using Cost = ceres::DynamicNumericDiffCostFunction<ImageCost, ceres::CENTRAL>;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    for (const Shot& shot : cameras[c].shots) {
      if (shot.corners.empty()) continue;
      auto cost = std::make_unique<Cost>(new ImageCost(problem.points, shot.corners));
      for (const int size : {9, 6, 6}) cost->AddParameterBlock(size);
      cost->SetNumResiduals(2 * static_cast<int>(shot.corners.size()));
      problem.ceres.AddResidualBlock(
          cost.release(), nullptr,
          {problem.lenses[c].data(), problem.poses[c].data(), problem.boards[shot.key].data()});
    }
    std::vector<int> fixed;
    for (int i = 4 + lens_terms; i < 9; ++i) fixed.push_back(i);
    if (!fixed.empty())
      problem.ceres.SetManifold(problem.lenses[c].data(), new ceres::SubsetManifold(9, fixed));
  }
  problem.ceres.SetParameterBlockConstant(problem.poses[0].data());
}

Eigen::Matrix3d cross_matrix(const Vector3d& v) {
  Eigen::Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

/// How a small change of the rotation vector turns the camera: w with exp(w) R(r) = R(r + dr), by
/// dr (the left Jacobian of the rotation group).
Eigen::Matrix3d turn_by_vector(const Vector3d& r) {
  const double angle = r.norm();
  if (angle < 1e-9) return Eigen::Matrix3d::Identity();
  const Vector3d a = r / angle;
  const double s = std::sin(angle) / angle;
  return s * Eigen::Matrix3d::Identity() + (1 - s) * a * a.transpose() +
         (1 - std::cos(angle)) / angle * cross_matrix(a);
}

struct PoseDeviation {
  double position_mm = 0, rotation_rad = 0;
};

PoseDeviation pose_deviation(const Motion& motion, const Eigen::Matrix<double, 6, 6>& covariance) {
  const Transform pose = to_transform(motion.data());
  const Eigen::Matrix3d turn = turn_by_vector({motion[0], motion[1], motion[2]});
  Eigen::Matrix<double, 3, 6> centre;  // C = -R't moves by -R' [t]x w - R' dt
  centre << -pose.R.transpose() * cross_matrix(pose.t) * turn, -pose.R.transpose();
  const Eigen::Matrix3d turns = turn * covariance.topLeftCorner<3, 3>() * turn.transpose();
  return {std::sqrt((centre * covariance * centre.transpose()).trace()), std::sqrt(turns.trace())};
}

/// Standard deviations: of an image coordinate from the residuals, of the rest by the inverse of
/// the normal matrix.
std::vector<CameraUncertainty> uncertainty(Problem& problem, double squares) {
  const double freedom =
      problem.ceres.NumResiduals() - 9.0 * static_cast<double>(problem.lenses.size()) -
      6.0 * static_cast<double>(problem.boards.size() + problem.poses.size() - 1);
  const double variance_px2 = squares / std::max(1.0, freedom);
  std::vector<std::pair<const double*, const double*>> blocks;
  for (const Lens& lens : problem.lenses) blocks.emplace_back(lens.data(), lens.data());
  for (std::size_t c = 1; c < problem.poses.size(); ++c)
    blocks.emplace_back(problem.poses[c].data(), problem.poses[c].data());
  ceres::Covariance covariance({});
  if (!covariance.Compute(blocks, &problem.ceres))
    throw Error(
        "the images leave the cameras undetermined; expected boards in other places of the "
        "images, at other distances and tilts");
  std::vector<CameraUncertainty> out(problem.lenses.size());
  for (std::size_t c = 0; c < out.size(); ++c) {
    Eigen::Matrix<double, 9, 9, Eigen::RowMajor> lens;
    covariance.GetCovarianceBlock(problem.lenses[c].data(), problem.lenses[c].data(), lens.data());
    out[c].focal_px = std::sqrt(variance_px2 * std::max(lens(0, 0), lens(1, 1)));
    if (c == 0) continue;
    Eigen::Matrix<double, 6, 6, Eigen::RowMajor> pose;
    covariance.GetCovarianceBlock(problem.poses[c].data(), problem.poses[c].data(), pose.data());
    const PoseDeviation deviation = pose_deviation(problem.poses[c], variance_px2 * pose);
    out[c].position_mm = deviation.position_mm;
    out[c].rotation_rad = deviation.rotation_rad;
  }
  return out;
}

}  // namespace

std::vector<CameraUncertainty> adjust(RigEstimate& rig, const std::vector<CameraShots>& cameras,
                                      const Board& board, const CalibrateOptions& options) {
  Problem problem;
  build(problem, rig, cameras, board, options.lens_terms);
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_SCHUR;
  solver.max_num_iterations = 200;
  solver.function_tolerance = 1e-12;  // a millionth of a pixel in the residuals
  solver.logging_type = ceres::SILENT;
  FLAGS_minloglevel = google::GLOG_FATAL;  // what the solver has to say comes as an Error
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem.ceres, &summary);
  if (!summary.IsSolutionUsable())
    throw Error("the calibration does not converge; expected images of one flat board");
  for (std::size_t c = 0; c < rig.cameras.size(); ++c) {
    set_lens(rig.cameras[c], problem.lenses[c].data());
    rig.cameras[c].camera_from_world = to_transform(problem.poses[c].data());
  }
  for (auto& [key, pose] : rig.world_from_board) pose = to_transform(problem.boards[key].data());
  return uncertainty(problem, 2 * summary.final_cost);
}

}  // namespace trihedron
