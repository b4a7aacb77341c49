// SPDX-License-Identifier: Apache-2.0
#include "recognition/refinement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// Systematic error of a predicted edge's image, px: calibration and mesh, which noise does not
/// show. Keeps noise-free points from overruling all others.
constexpr double kModelPx = 0.1;
/// Error of a profile with another line inside its bell, px.
constexpr double kCrowdedPx = 1.0;
/// Error of a contour pixel's centre across the contour, px: thinning to whole pixels.
constexpr double kPixelPx = 0.5;
/// Residuals beyond this many robust standard deviations do not count (Tukey's 95 % point).
constexpr double kTukey = 4.685;
/// A profile speaks when its height exceeds this many standard deviations of image noise.
constexpr double kClearHeight = 4.0;
/// Gradient noise is correlated over the front end's window, px.
constexpr double kCorrelationPx = 3.0;
/// Spacing of the points whose exact positions are asked for, px.
constexpr double kExactStepPx = 4;
/// Robust solutions on what one round found: motions are so small by then that residuals follow
/// them linearly.
constexpr int kSolutions = 2;
/// Weak prior on the motion in one round: directions that no contour fixes stay where they are.
constexpr double kPriorRad = 0.2, kPriorMm = 20.0;

/// One line of the least-squares problem.
struct Residual {
  Eigen::Matrix<double, 1, 6> jacobian;
  double value = 0;  // px, observed minus predicted along the normal
  double sigma = 1;  // px, expected
  double weight = 0;
  int group = 0;  // pieces: their residuals share errors
};

double robust_scale(std::vector<Residual>& residuals) {
  std::vector<double> z;
  for (const Residual& r : residuals) z.push_back(std::abs(r.value) / r.sigma);
  if (z.empty()) return 1;
  const auto middle = z.begin() + static_cast<std::ptrdiff_t>(z.size() / 2);
  std::nth_element(z.begin(), middle, z.end());
  return std::max(1.0, *middle / 0.6745);
}

void weigh(std::vector<Residual>& residuals) {
  const double cut = kTukey * robust_scale(residuals);
  for (Residual& r : residuals) {
    const double z = r.value / r.sigma / cut;
    const double bell = std::abs(z) < 1 ? (1 - z * z) * (1 - z * z) : 0;
    r.weight = bell / (r.sigma * r.sigma);
  }
}

Matrix6d prior() {
  Vector6d diagonal;
  diagonal << Eigen::Vector3d::Constant(1 / (kPriorRad * kPriorRad)),
      Eigen::Vector3d::Constant(1 / (kPriorMm * kPriorMm));
  return diagonal.asDiagonal();
}

/// Adds the weighted square of a residual's row to the normal matrix.
void add_square(const Residual& r, Matrix6d& normal) {
  const Vector6d weighted = r.weight * r.jacobian.transpose();
  for (Eigen::Index column = 0; column < 6; ++column) {
    normal.col(column) += r.jacobian[column] * weighted;
  }
}

Vector6d solve(const std::vector<Residual>& residuals) {
  Matrix6d normal = prior();
  Vector6d right = Vector6d::Zero();
  for (const Residual& r : residuals) {
    if (r.weight == 0) continue;
    add_square(r, normal);
    right += r.weight * r.value * r.jacobian.transpose();
  }
  return normal.ldlt().solve(right);
}

/// Points of all views, for contours or for the exact positions: only there crowding matters.
std::vector<EdgePoint> all_points(const std::vector<FieldView>& views,
                                  const std::vector<PlacedModel>& objects, int index, bool exact) {
  constexpr double kCoarseStepPx = 8, kCoarseEndPx = 2, kEndPx = 4;
  std::vector<EdgePoint> out;
  for (int v = 0; v < static_cast<int>(views.size()); ++v) {
    const auto edges = visible_edges(*views[v].camera, objects, index);
    auto points = edge_points(views[v], v, edges, exact ? kExactStepPx : kCoarseStepPx,
                              exact ? kEndPx : kCoarseEndPx);
    if (exact) mark_crowded(edges, points);
    out.insert(out.end(), points.begin(), points.end());
  }
  return out;
}

Eigen::Matrix<double, 1, 6> line_jacobian(const FieldView& view, const EdgePoint& p,
                                          const Eigen::Vector3d& origin) {
  const auto image = view.camera->projection_jacobian(p.x_in_world);
  const Eigen::Vector3d along = image.transpose().lazyProduct(p.normal);
  Eigen::Matrix<double, 1, 6> out;
  out << (p.x_in_world - origin).cross(along).transpose(), along.transpose();
  return out;
}

std::vector<Residual> contour_residuals(const std::vector<FieldView>& views,
                                        const std::vector<EdgePoint>& points,
                                        const Eigen::Vector3d& origin, double reach_mm) {
  std::vector<Residual> out;
  out.reserve(points.size());
  std::vector<double> reach_px;
  for (const FieldView& view : views) {
    reach_px.push_back(std::max(kNarrowPx, reach_mm * view.camera->px_per_mm_at(origin)));
  }
  for (const EdgePoint& p : points) {
    const double d = views[p.view].field->nearest_contour(p.x, p.normal, reach_px[p.view]);
    if (std::isnan(d)) continue;
    Residual r;
    r.value = d;
    r.sigma = kPixelPx;
    r.jacobian = line_jacobian(views[p.view], p, origin);
    out.push_back(r);
  }
  return out;
}

double exact_sigma(double noise_px, bool crowded) {
  const double model_px = crowded ? kCrowdedPx : kModelPx;
  return std::sqrt(noise_px * noise_px + model_px * model_px);
}

std::vector<Residual> exact_residuals(const std::vector<FieldView>& views,
                                      const std::vector<EdgePoint>& points,
                                      const Eigen::Vector3d& origin) {
  std::vector<Residual> out;
  out.reserve(points.size());
  for (const EdgePoint& p : points) {
    const EdgeProfile profile = views[p.view].field->profile(p.x, p.normal);
    if (!speaks(profile)) continue;
    Residual r;
    r.value = profile.offset_px;
    r.sigma = exact_sigma(profile.sigma_px, p.crowded);
    r.jacobian = line_jacobian(views[p.view], p, origin);
    r.group = p.view * 1024 + p.piece;
    out.push_back(r);
  }
  return out;
}

/// Covariance of the solution from the residuals themselves: those of one piece may share an
/// error (sandwich estimate), and it never falls below what independent noise would give.
Matrix6d covariance(const std::vector<Residual>& residuals, double step_px) {
  Matrix6d normal = prior(), shared = Matrix6d::Zero();
  Vector6d piece = Vector6d::Zero();
  double chi2 = 0, weights = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Residual& r = residuals[i];
    add_square(r, normal);
    piece += r.weight * r.value * r.jacobian.transpose();
    chi2 += r.weight * r.value * r.value;
    weights += r.weight * r.sigma * r.sigma;
    if (i + 1 == residuals.size() || residuals[i + 1].group != r.group) {
      shared += piece * piece.transpose();
      piece.setZero();
    }
  }
  const Matrix6d inverse = normal.ldlt().solve(Matrix6d::Identity());
  const double correlated = std::max(1.0, kCorrelationPx / step_px);
  const double scale = correlated * std::max(1.0, chi2 / std::max(1.0, weights - 6));
  return inverse * shared * inverse + scale * inverse;
}

double weighted_rms(const std::vector<Residual>& residuals, int& used) {
  double sum = 0;
  used = 0;
  for (const Residual& r : residuals) {
    if (r.weight == 0) continue;
    sum += r.value * r.value;
    ++used;
  }
  return used ? std::sqrt(sum / used) : 0;
}

}  // namespace

Transform moved(const Transform& pose, const Vector6d& motion) {
  const Eigen::Vector3d w = motion.head<3>();
  const double angle = w.norm();
  Transform out = pose;
  if (angle > 0) out.R = Eigen::AngleAxisd(angle, w / angle).toRotationMatrix() * pose.R;
  out.t += motion.tail<3>();
  return out;
}

Eigen::Matrix<double, 2, 6> motion_jacobian(const Camera& camera, const Eigen::Vector3d& x_in_world,
                                            const Eigen::Vector3d& origin_in_world) {
  const Eigen::Matrix<double, 2, 3> image = camera.projection_jacobian(x_in_world);
  const Eigen::Vector3d a = x_in_world - origin_in_world;
  Eigen::Matrix<double, 3, 6> motion;   // d(w x a + t)
  motion << 0, a.z(), -a.y(), 1, 0, 0,  //
      -a.z(), 0, a.x(), 0, 1, 0,        //
      a.y(), -a.x(), 0, 0, 0, 1;
  return image * motion;
}

bool speaks(const EdgeProfile& profile) {
  constexpr double kReachPx = 1.99;  // beyond, the bell ran into its stop
  return std::abs(profile.height) >= kClearHeight * profile.sigma_height &&
         std::abs(profile.offset_px) < kReachPx;
}

RefinedPose refine(const std::vector<FieldView>& views, std::vector<PlacedModel> objects, int index,
                   const RefinementOptions& options) {
  Transform& pose = objects[index].world_from_model;
  RefinedPose out;
  for (double reach_mm : options.reaches_mm) {
    const auto points = all_points(views, objects, index, false);
    auto residuals = contour_residuals(views, points, pose.t, reach_mm);
    weigh(residuals);
    pose = moved(pose, solve(residuals));
  }
  std::vector<Residual> residuals;
  for (int round = 0; round < options.exact_rounds; ++round) {
    const auto points = all_points(views, objects, index, true);
    residuals = exact_residuals(views, points, pose.t);
    for (int solution = 0; solution < kSolutions; ++solution) {
      weigh(residuals);
      const Vector6d motion = solve(residuals);
      pose = moved(pose, motion);
      for (Residual& r : residuals) r.value -= r.jacobian.dot(motion.transpose());
    }
  }
  out.world_from_model = pose;
  out.covariance = covariance(residuals, kExactStepPx);
  out.rms_px = weighted_rms(residuals, out.points);
  out.converged = out.points >= 12;
  return out;
}

}  // namespace trihedron
