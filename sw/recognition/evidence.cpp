// SPDX-License-Identifier: Apache-2.0
#include "recognition/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCellPx = 8;

/// Distance of a point from a segment (its ends included), px.
double distance(const Segment& s, const Vector2d& p) {
  const double t = std::clamp(s.along(p), 0.0, s.length);
  return (p - s.p0 - t * s.direction).norm();
}

struct Cells {
  int x0, x1, y0, y1;
};

Cells around(const Segment& s, double reach, int columns, int rows) {
  const auto cell = [](double v, int n) {
    return std::clamp(static_cast<int>(std::floor(v / kCellPx)), 0, n - 1);
  };
  return {cell(std::min(s.p0.x(), s.p1.x()) - reach, columns),
          cell(std::max(s.p0.x(), s.p1.x()) + reach, columns),
          cell(std::min(s.p0.y(), s.p1.y()) - reach, rows),
          cell(std::max(s.p0.y(), s.p1.y()) + reach, rows)};
}

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
    grids_.push_back(make_grid(v));
    double covered = 0;
    for (const Segment& s : v.segments) covered += s.length * 2 * options.tolerance_px;
    // Chance of a sample of any direction to hit some segment, were they spread over the image.
    const double share = covered / (static_cast<double>(v.width) * v.height);
    const double chance = std::clamp(share * 2 * options.tolerance_rad / kPi, 0.01, 0.3);
    log_hit_.push_back(std::log(options.hit_probability / chance));
    log_miss_.push_back(std::log((1 - options.hit_probability) / (1 - chance)));
  }
}

Evidence::Grid Evidence::make_grid(const ViewLines& v) const {
  Grid g;
  g.columns = std::max(1, static_cast<int>(std::ceil(v.width / kCellPx)));
  g.rows = std::max(1, static_cast<int>(std::ceil(v.height / kCellPx)));
  std::vector<std::vector<std::int32_t>> cells(static_cast<std::size_t>(g.columns * g.rows));
  const double reach = options_.tolerance_px + kCellPx * 0.7072;
  for (std::size_t i = 0; i < v.segments.size(); ++i) {
    const Segment& s = v.segments[i];
    g.strokes.push_back({static_cast<float>(s.normal.x()), static_cast<float>(s.normal.y()),
                         static_cast<float>(s.normal.dot(s.p0)),
                         static_cast<float>(s.direction.dot(s.p0)), static_cast<float>(s.length)});
    const Cells c = around(s, reach, g.columns, g.rows);
    for (int y = c.y0; y <= c.y1; ++y) {
      for (int x = c.x0; x <= c.x1; ++x) {
        const Vector2d centre((x + 0.5) * kCellPx, (y + 0.5) * kCellPx);
        if (distance(s, centre) > reach) continue;
        cells[static_cast<std::size_t>(y * g.columns + x)].push_back(static_cast<int>(i));
      }
    }
  }
  g.start.push_back(0);
  for (const auto& c : cells) {
    g.segment.insert(g.segment.end(), c.begin(), c.end());
    g.start.push_back(static_cast<std::int32_t>(g.segment.size()));
  }
  return g;
}

/// The segment nearest to an image position among those of about the direction (dx, dy).
int Evidence::find(const Grid& g, float x, float y, float dx, float dy) const {
  if (!(x >= 0 && y >= 0)) return kOutside;
  const int column = static_cast<int>(x) / static_cast<int>(kCellPx);
  const int row = static_cast<int>(y) / static_cast<int>(kCellPx);
  if (column >= g.columns || row >= g.rows) return kOutside;
  const auto cell = static_cast<std::size_t>(row * g.columns + column);
  const auto reach = static_cast<float>(options_.tolerance_px);
  const auto max_sine = static_cast<float>(options_.tolerance_rad);
  int found = kMiss;
  float best = reach;
  for (auto i = g.start[cell]; i < g.start[cell + 1]; ++i) {
    const int k = g.segment[static_cast<std::size_t>(i)];
    const Stroke& s = g.strokes[static_cast<std::size_t>(k)];
    const float across = std::abs(s.nx * x + s.ny * y - s.offset);
    if (across >= best || std::abs(s.nx * dx + s.ny * dy) > max_sine) continue;
    const float t = s.ny * x - s.nx * y - s.start;
    if (t < -reach || t > s.length + reach) continue;
    best = across;
    found = k;
  }
  return found;
}

/// Calls the visitor for samples, inside the image, of the edges that turn a surface to a view.
template <typename Visitor>
void Evidence::visit_view(std::size_t view, const Model& model, const Transform& pose,
                          int max_samples, Visitor&& visitor) const {
  thread_local std::vector<Eigen::Vector2f> image;
  thread_local std::vector<char> facing;
  const IdealView& ideal = views_[view].ideal;
  const Eigen::Matrix3d A = ideal.matrix().leftCols<3>() * pose.R;
  const Vector3d b = ideal.matrix().leftCols<3>() * pose.t + ideal.matrix().col(3);
  image.clear();
  for (const Vector3d& x : model.mesh.vertices) {
    const Vector3d h = A * x + b;
    if (h.z() < 1e-3) return;  // behind the camera
    image.emplace_back(static_cast<float>(h.x() / h.z()), static_cast<float>(h.y() / h.z()));
  }
  facing.clear();
  const Vector3d from = pose.R.transpose() * (ideal.centre() - pose.t);
  const Vector3d axis = pose.R.transpose() * ideal.axis();
  for (const Surface& s : model.surfaces) {
    const bool front =
        ideal.orthographic() ? s.normal.dot(axis) < 0 : s.normal.dot(from) > s.offset;
    facing.push_back(front ? 1 : 0);
  }
  constexpr float kMinLengthPx = 5;  // shorter ones have no direction
  for (const ModelEdge& e : model.edges) {
    if (!facing[static_cast<std::size_t>(e.left)] && !facing[static_cast<std::size_t>(e.right)]) {
      continue;
    }
    const Eigen::Vector2f p = image[static_cast<std::size_t>(e.v0)];
    const Eigen::Vector2f d = image[static_cast<std::size_t>(e.v1)] - p;
    const float length = d.norm();
    if (length < kMinLengthPx) continue;
    const int n = std::clamp(static_cast<int>(length / static_cast<float>(options_.sample_px)), 1,
                             max_samples);
    for (int k = 0; k < n; ++k) {
      const float f = (static_cast<float>(k) + 0.5F) / static_cast<float>(n);
      const int hit =
          find(grids_[view], p.x() + f * d.x(), p.y() + f * d.y(), d.x() / length, d.y() / length);
      if (hit != kOutside) visitor(Sample{view, &e, f, hit});
    }
  }
}

template <typename Visitor>
void Evidence::visit(const Model& model, const Transform& pose, int max_samples,
                     Visitor&& visitor) const {
  for (std::size_t v = 0; v < views_.size(); ++v) visit_view(v, model, pose, max_samples, visitor);
}

double Evidence::score(const Model& model, const Transform& pose, int max_samples) const {
  double sum = 0;
  visit(model, pose, max_samples,
        [&](const Sample& s) { sum += s.segment >= 0 ? log_hit_[s.view] : log_miss_[s.view]; });
  return sum;
}

void Evidence::refine(const Model& model, Transform& pose, int max_samples) const {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  const Vector3d centre = pose * model.surfaces[0].centroid;
  visit(model, pose, max_samples, [&](const Sample& s) {
    if (s.segment < 0) return;
    const ViewLines& view = views_[s.view];
    const Vector3d x =
        pose * ((1 - s.along) * model.mesh.vertices[static_cast<std::size_t>(s.edge->v0)] +
                s.along * model.mesh.vertices[static_cast<std::size_t>(s.edge->v1)]);
    // Distance from the plane of sight, in px at that depth.
    const Plane& plane = view.planes[static_cast<std::size_t>(s.segment)];
    const double scale = view.ideal.px_per_mm(x);
    Eigen::Matrix<double, 6, 1> J;
    J << (x - centre).cross(plane.normal), plane.normal;
    J *= scale;
    A += J * J.transpose();
    b -= scale * plane.distance(x) * J;
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

void Evidence::claim(const Model& model, const Transform& pose, double min_share,
                     Claims& claimed) const {
  int samples = 0;
  std::vector<std::pair<std::size_t, std::size_t>> hits;
  visit(model, pose, 8, [&](const Sample& s) {
    ++samples;
    if (s.segment >= 0) hits.emplace_back(s.view, static_cast<std::size_t>(s.segment));
  });
  if (static_cast<double>(hits.size()) < min_share * samples) return;
  for (const auto& [view, segment] : hits) claimed[view][segment] = 1;
}

}  // namespace trihedron
