// SPDX-License-Identifier: Apache-2.0
#include "recognition/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recognition/view_lanes.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// An edge's image shorter than this has no direction, px.
constexpr float kMinLengthPx = 5;
/// Nearer than this a camera sees nothing, mm.
constexpr float kNearestMm = 1e-3F;
/// The evidence falls as low as -x for a pose that is right with a probability of exp(-x), were
/// all samples independent; samples of an object that others hide are not.
constexpr double kHopeless = 8;

}  // namespace

bool all_claimed(const SpaceEdge& e, const Claims& claimed) {
  for (std::size_t v = 0; v < claimed.size(); ++v) {
    if (e.segment[v] >= 0 && !claimed[v][static_cast<std::size_t>(e.segment[v])]) return false;
  }
  return true;
}

Evidence::Evidence(const std::vector<ViewLines>& views, const EvidenceOptions& options)
    : views_(views), options_(options) {
  constexpr double kPi = 3.14159265358979323846;
  for (const ViewLines& v : views) {
    grids_.emplace_back(v.segments, v.width, v.height, options.tolerance_px, options.tolerance_rad);
    double covered = 0;
    for (const Segment& s : v.segments) covered += s.length * 2 * options.tolerance_px;
    // Chance of a sample of any direction to hit some segment, were they spread over the image.
    const double share = covered / (static_cast<double>(v.width) * v.height);
    const double chance = std::clamp(share * 2 * options.tolerance_rad / kPi, 0.01, 0.3);
    log_hit_.push_back(std::log(options.hit_probability / chance));
    log_miss_.push_back(std::log((1 - options.hit_probability) / (1 - chance)));
  }
}

/// Calls the visitor for samples, inside the images, of the edges that turn a surface to a view,
/// edge by edge, until it returns false.
template <typename Visitor>
void Evidence::visit(const ModelSketch& model, const Transform& pose, int max_samples,
                     Visitor&& visitor) const {
  const auto spacing = static_cast<float>(options_.sample_px);
  for (std::size_t first = 0; first < views_.size(); first += ViewLanes::kLanes) {
    const ViewLanes lanes(views_, first, pose);
    for (const EdgeSketch& e : model.edges) {
      const ViewLanes::Lanes facing =
          lanes.facing(e.left, e.left_offset).max(lanes.facing(e.right, e.right_offset));
      if (!(facing > 0).any()) continue;
      const ViewLanes::Images p = lanes.project(e.x0), q = lanes.project(e.x1);
      const ViewLanes::Lanes dx = q.x - p.x, dy = q.y - p.y, length = (dx * dx + dy * dy).sqrt();
      const ViewLanes::Lanes depth = p.depth.min(q.depth);
      for (std::size_t lane = 0; lane < lanes.count(); ++lane) {
        const auto i = static_cast<Eigen::Index>(lane);
        if (!(facing[i] > 0 && depth[i] > kNearestMm && length[i] >= kMinLengthPx)) continue;
        const int n = std::clamp(static_cast<int>(length[i] / spacing), 1, max_samples);
        for (int k = 0; k < n; ++k) {
          const float f = (static_cast<float>(k) + 0.5F) / static_cast<float>(n);
          const int hit = grids_[first + lane].find(p.x[i] + f * dx[i], p.y[i] + f * dy[i],
                                                    dx[i] / length[i], dy[i] / length[i]);
          if (hit == SegmentGrid::kOutside) continue;
          if (!visitor(Sample{first + lane, &e, f, hit})) return;
        }
      }
    }
  }
}

double Evidence::score(const ModelSketch& model, const Transform& pose, int max_samples) const {
  double sum = 0;
  visit(model, pose, max_samples, [&](const Sample& s) {
    sum += s.segment >= 0 ? log_hit_[s.view] : log_miss_[s.view];
    return true;
  });
  return sum;
}

bool Evidence::hopeless(const ModelSketch& model, const Transform& pose) const {
  double sum = 0;
  visit(model, pose, 1, [&](const Sample& s) {
    sum += s.segment >= 0 ? log_hit_[s.view] : log_miss_[s.view];
    return sum >= -kHopeless;
  });
  return sum <= 0;
}

void Evidence::refine(const ModelSketch& model, Transform& pose, int max_samples) const {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  const Vector3d centre = pose * model.vertex_mean;
  visit(model, pose, max_samples, [&](const Sample& s) {
    if (s.segment < 0) return true;
    const ViewLines& view = views_[s.view];
    const EdgeSketch& e = *s.edge;
    const Vector3d x = pose * (e.x0 + s.along * (e.x1 - e.x0)).cast<double>();
    // Distance from the plane of sight, in px at that depth.
    const Plane& plane = view.planes[static_cast<std::size_t>(s.segment)];
    const double scale = view.ideal.px_per_mm(x);
    Eigen::Matrix<double, 6, 1> J;
    J << (x - centre).cross(plane.normal), plane.normal;
    J *= scale;
    A.noalias() += J * J.transpose();
    b -= scale * plane.distance(x) * J;
    return true;
  });
  // A sample's weight of prior keeps the motions that no segment constrains at rest.
  A.diagonal().head<3>().array() += model.diameter * model.diameter / 4;
  A.diagonal().tail<3>().array() += 1;
  const Eigen::Matrix<double, 6, 1> step = A.ldlt().solve(b);
  const Vector3d w = step.head<3>();
  const double angle = w.norm();
  constexpr double kLargestTurn = 0.5;  // beyond, the samples were not of this object
  if (!(angle < kLargestTurn)) return;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if (angle > 0) R = Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
  pose.t = R * (pose.t - centre) + centre + step.tail<3>();
  pose.R = R * pose.R;
}

void Evidence::claim(const ModelSketch& model, const Transform& pose, double min_share,
                     Claims& claimed) const {
  int samples = 0;
  std::vector<std::pair<std::size_t, std::size_t>> hits;
  visit(model, pose, 8, [&](const Sample& s) {
    ++samples;
    if (s.segment >= 0) hits.emplace_back(s.view, static_cast<std::size_t>(s.segment));
    return true;
  });
  if (static_cast<double>(hits.size()) < min_share * samples) return;
  for (const auto& [view, segment] : hits) claimed[view][segment] = 1;
}

}  // namespace trihedron
