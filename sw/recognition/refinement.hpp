// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/camera.hpp"
#include "recognition/contour_field.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// `pose` moved by the small motion (rotation vector rad about the pose's own origin,
/// translation mm), both in the world frame.
Transform moved(const Transform& pose, const Vector6d& motion);

/// The image's change in px of a point of the object per unit of that motion.
/// `origin_in_world` is the pose's t.
Eigen::Matrix<double, 2, 6> motion_jacobian(const Camera& camera, const Eigen::Vector3d& x_in_world,
                                            const Eigen::Vector3d& origin_in_world);

/// A view as refinement and verification use it.
struct FieldView {
  const Camera* camera = nullptr;
  const ContourField* field = nullptr;
};

/// A point on a visible edge, the unit of evidence.
struct EdgePoint {
  int view = 0;
  int piece = 0;               ///< index of the visible piece within this view
  Eigen::Vector3d x_in_world;  ///< mm
  Eigen::Vector2d x;           ///< px
  Eigen::Vector2d normal;      ///< unit, px, away from the piece's surface
  bool crowded = false;        ///< see mark_crowded
};

/// Points on visible pieces `step_px` apart, `end_px` away from the pieces' ends (where other
/// lines meet them) and inside the image by the profile's reach, or at most `outside_px` outside
/// that.
std::vector<EdgePoint> edge_points(const FieldView& view, int view_index,
                                   const std::vector<VisibleEdge>& edges, double step_px,
                                   double end_px, double outside_px = 0);

/// Marks the points of one view's pieces near which another edge's line runs: too near for a clean
/// profile.
void mark_crowded(const std::vector<VisibleEdge>& edges, std::vector<EdgePoint>& points);

/// Whether the gradient shows an edge where the profile was asked for: a height clear of image
/// noise, and the edge within the profile's reach.
bool speaks(const EdgeProfile& profile);

struct RefinementOptions {
  /// How far contours are searched for across a predicted edge, mm at the object, one search
  /// after another, and at least kNarrowPx.
  std::vector<double> reaches_mm = {10, 10, 5, 5, 2.5, 2.5, 1, 1};
  /// Looks at the gradient profiles, the exact positions, once contours are met.
  int exact_rounds = 2;
};

/// Narrowest search for contours, px: less than this the thinning to whole pixels disturbs.
inline constexpr double kNarrowPx = 3;

struct RefinedPose {
  Transform world_from_model;
  Matrix6d covariance = Matrix6d::Zero();  ///< of the motion of moved(), world
  double rms_px = 0;                       ///< of the exact residuals, outliers left out
  int points = 0;                          ///< that took part in the last round
  bool converged = false;                  ///< enough points in enough directions
};

/// The pose near `objects[index]` that puts the visible edges of that object onto the contours
/// of all views: robust least squares, wide search first. The other objects only hide edges.
RefinedPose refine(const std::vector<FieldView>& views, std::vector<PlacedModel> objects, int index,
                   const RefinementOptions& options = {});

}  // namespace trihedron
