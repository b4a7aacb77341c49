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

Evidence::Evidence(const std::vector<ViewLines>& views, const EvidenceOptions& options)
    : views_(views), options_(options), cosine_(std::cos(options.tolerance_rad)) {
  int count = 0;
  for (const ViewLines& v : views) {
    first_.push_back(count);
    count += static_cast<int>(v.segments.size());
    Grid g;
    g.columns = std::max(1, static_cast<int>(std::ceil(v.width / kCellPx)));
    g.rows = std::max(1, static_cast<int>(std::ceil(v.height / kCellPx)));
    std::vector<std::vector<std::int32_t>> cells(static_cast<std::size_t>(g.columns * g.rows));
    const double reach = options.tolerance_px + kCellPx * 0.7072;
    double covered = 0;
    for (std::size_t i = 0; i < v.segments.size(); ++i) {
      const Segment& s = v.segments[i];
      covered += s.length * 2 * options.tolerance_px;
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
    grids_.push_back(std::move(g));
    // Chance of a sample of any direction to hit some segment, were they spread over the image.
    const double chance = std::clamp(
        covered / (v.width * v.height) * 2 * options.tolerance_rad / 3.14159265, 0.01, 0.3);
    log_hit_.push_back(std::log(options.hit_probability / chance));
    log_miss_.push_back(std::log((1 - options.hit_probability) / (1 - chance)));
  }
}

int Evidence::find(std::size_t view, const Vector2d& p, const Vector2d& direction) const {
  const Grid& g = grids_[view];
  const int x = static_cast<int>(p.x() / kCellPx), y = static_cast<int>(p.y() / kCellPx);
  if (p.x() < 0 || p.y() < 0 || x >= g.columns || y >= g.rows) return -2;
  const auto cell = static_cast<std::size_t>(y * g.columns + x);
  int found = -1;
  double best = options_.tolerance_px;
  for (auto i = g.start[cell]; i < g.start[cell + 1]; ++i) {
    const int k = g.segment[static_cast<std::size_t>(i)];
    const Segment& s = views_[view].segments[static_cast<std::size_t>(k)];
    const double across = std::abs(s.distance(p));
    if (across >= best || std::abs(s.direction.dot(direction)) < cosine_) continue;
    const double t = s.along(p);
    if (t < -options_.tolerance_px || t > s.length + options_.tolerance_px) continue;
    best = across;
    found = k;
  }
  return found;
}

/// Calls visitor(view, edge, position along it 0..1, image position, segment or -1) for samples
/// inside the images.
template <typename Visitor>
void Evidence::visit(const Model& model, const Transform& pose, int max_samples,
                     Visitor&& visitor) const {
  thread_local std::vector<Vector3d> world;
  thread_local std::vector<Vector2d> image;
  thread_local std::vector<char> facing;
  world.clear();
  for (const Vector3d& x : model.mesh.vertices) world.push_back(pose * x);
  for (std::size_t v = 0; v < views_.size(); ++v) {
    const IdealView& ideal = views_[v].ideal;
    image.clear();
    bool behind = false;
    for (const Vector3d& x : world) {
      behind = behind || ideal.depth(x) < 1e-3;
      image.push_back(ideal.project(x));
    }
    if (behind) continue;
    facing.clear();
    for (const Surface& s : model.surfaces) {
      const Vector3d on = world[static_cast<std::size_t>(s.loops[0][0])];
      facing.push_back((pose.R * s.normal).dot(ideal.sight(on)) < 0 ? 1 : 0);
    }
    for (const ModelEdge& e : model.edges) {
      if (!facing[static_cast<std::size_t>(e.left)] && !facing[static_cast<std::size_t>(e.right)]) {
        continue;
      }
      const Vector2d p = image[static_cast<std::size_t>(e.v0)];
      const Vector2d d = image[static_cast<std::size_t>(e.v1)] - p;
      const double length = d.norm();
      if (length < 5) continue;  // too short for a direction
      const int n = std::clamp(static_cast<int>(length / options_.sample_px), 1, max_samples);
      for (int k = 0; k < n; ++k) {
        const double f = (k + 0.5) / n;
        const Vector2d q = p + f * d;
        const int hit = find(v, q, d / length);
        if (hit != -2) visitor(v, e, f, q, hit);
      }
    }
  }
}

double Evidence::score(const Model& model, const Transform& pose, int max_samples) const {
  double sum = 0;
  visit(model, pose, max_samples,
        [&](std::size_t v, const ModelEdge&, double, const Vector2d&, int hit) {
          sum += hit >= 0 ? log_hit_[v] : log_miss_[v];
        });
  return sum;
}

double Evidence::refine(const Model& model, Transform& pose) const {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  const Vector3d centre = pose * model.surfaces[0].centroid;
  double sum = 0;
  visit(model, pose, 8,
        [&](std::size_t v, const ModelEdge& e, double f, const Vector2d& q, int hit) {
          sum += hit >= 0 ? log_hit_[v] : log_miss_[v];
          if (hit < 0) return;
          const ViewLines& view = views_[v];
          const auto k = static_cast<std::size_t>(hit);
          const Vector3d x = pose * ((1 - f) * model.mesh.vertices[static_cast<std::size_t>(e.v0)] +
                                     f * model.mesh.vertices[static_cast<std::size_t>(e.v1)]);
          (void)q;
          // Distance from the interpretation plane, in px at that depth.
          const Plane& plane = view.planes[k];
          const double scale = view.ideal.px_per_mm(x);
          Eigen::Matrix<double, 6, 1> J;
          J << (x - centre).cross(plane.normal), plane.normal;
          J *= scale;
          const double r = scale * plane.distance(x);
          A += J * J.transpose();
          b -= r * J;
        });
  // Half a pixel of prior per sample direction keeps unconstrained directions where they are.
  A.diagonal().head<3>().array() += 1.0 * model.diameter * model.diameter / 4;
  A.diagonal().tail<3>().array() += 1.0;
  const Eigen::Matrix<double, 6, 1> step = A.ldlt().solve(b);
  const Vector3d w = step.head<3>();
  const double angle = w.norm();
  if (!(angle < 0.5)) return sum;
  const Eigen::Matrix3d R = angle > 1e-12 ? Eigen::AngleAxisd(angle, w / angle).toRotationMatrix()
                                          : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  pose.t = R * (pose.t - centre) + centre + step.tail<3>();
  pose.R = R * pose.R;
  return sum;
}

std::vector<int> Evidence::explained(const Model& model, const Transform& pose) const {
  std::vector<int> out;
  visit(model, pose, 8, [&](std::size_t v, const ModelEdge&, double, const Vector2d&, int hit) {
    if (hit >= 0) out.push_back(first_[v] + hit);
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace trihedron
