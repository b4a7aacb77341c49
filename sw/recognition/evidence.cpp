// SPDX-License-Identifier: Apache-2.0
#include "recognition/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// An edge's image shorter than this has no direction, px.
constexpr float kMinLengthPx = 5;
/// Nearer than this a camera sees nothing, mm.
constexpr float kNearestMm = 1e-3F;
/// The evidence falls as low as -x for a pose that is right with a probability of exp(-x), were
/// all samples independent; samples of an object that others hide are not.
constexpr float kHopeless = 8;

/// A model's vertices and surfaces as up to four views see them: edges share them.
struct Seen {
  std::vector<ViewLanes::Images> vertices;
  std::vector<ViewLanes::Lanes> facing;  ///< surfaces, above 0: turned to the view

  void look(const ViewLanes& lanes, const ModelSketch& model) {
    vertices.resize(model.vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] = lanes.project(model.vertices[i]);
    facing.resize(model.surfaces.size());
    for (std::size_t i = 0; i < facing.size(); ++i) {
      facing[i] = lanes.facing(model.surfaces[i].normal, model.surfaces[i].offset);
    }
  }
};
/// Its memory is kept from pose to pose.
Seen& scratch() {
  thread_local Seen seen;
  return seen;
}

using Lanes = LaneRig::Lanes;
using LaneInts __attribute__((vector_size(sizeof(Lanes)))) = std::int32_t;

bool any(const LaneInts& mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

/// An edge in the images.
struct SeenEdge {
  SeenEdge(const Seen& seen, const ModelSketch::Edge& e)
      : p(seen.vertices[static_cast<std::size_t>(e.v0)]),
        q(seen.vertices[static_cast<std::size_t>(e.v1)]),
        dx(q.x - p.x),
        dy(q.y - p.y),
        squared(dx * dx + dy * dy),
        asked(((seen.facing[static_cast<std::size_t>(e.left)] > 0) |
               (seen.facing[static_cast<std::size_t>(e.right)] > 0)) &
              (p.depth > kNearestMm) & (q.depth > kNearestMm) &
              (squared >= kMinLengthPx * kMinLengthPx)) {}

  const ViewLanes::Images &p, &q;
  Lanes dx, dy, squared;  ///< px
  LaneInts asked;         ///< where the edge turns a surface to the view and is long enough
};

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
  for (std::size_t first = 0; first < views.size(); first += LaneRig::kLanes) {
    rigs_.emplace_back(views, first);
  }
  for (const ViewLines& v : views) {
    grids_.emplace_back(v.segments, v.width, v.height, options.tolerance_px, options.tolerance_rad);
    maps_.emplace_back(v.segments, v.width, v.height, options.tolerance_px, options.tolerance_rad);
    double covered = 0;
    for (const Segment& s : v.segments) covered += s.length * 2 * options.tolerance_px;
    // Chance of a sample of any direction to hit some segment, were they spread over the image.
    const double share = covered / (static_cast<double>(v.width) * v.height);
    const double chance = std::clamp(share * 2 * options.tolerance_rad / kPi, 0.01, 0.3);
    log_hit_.push_back(std::log(options.hit_probability / chance));
    log_miss_.push_back(std::log((1 - options.hit_probability) / (1 - chance)));
    odds_.push_back({static_cast<float>(log_miss_.back()), static_cast<float>(log_hit_.back())});
  }
}

/// Calls the visitor for samples, inside the images, of the edges that turn a surface to a view,
/// edge by edge, until it returns false.
template <typename Visitor>
void Evidence::visit(const ModelSketch& model, const Transform& pose, int max_samples,
                     Visitor&& visitor) const {
  const auto spacing = static_cast<float>(options_.sample_px);
  std::size_t first = 0;
  for (const LaneRig& rig : rigs_) {
    Seen& seen = scratch();
    seen.look(ViewLanes(rig, pose), model);
    for (const ModelSketch::Edge& e : model.edges) {
      const SeenEdge edge(seen, e);
      if (!any(edge.asked)) continue;
      const auto& [p, q, dx, dy, squared, asked] = edge;
      for (std::size_t lane = 0; lane < rig.count; ++lane) {
        const std::size_t i = lane;
        if (!asked[i]) continue;
        const float length = std::sqrt(squared[i]);
        const int n = std::clamp(static_cast<int>(length / spacing), 1, max_samples);
        for (int k = 0; k < n; ++k) {
          const float f = (static_cast<float>(k) + 0.5F) / static_cast<float>(n);
          const int hit = grids_[first + lane].find(p.x[i] + f * dx[i], p.y[i] + f * dy[i],
                                                    dx[i] / length, dy[i] / length);
          if (hit == SegmentGrid::kOutside) continue;
          if (!visitor(Sample{first + lane, &e, f, hit})) return;
        }
      }
    }
    first += rig.count;
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

namespace {

/// px to the cells of a map; what lies left of the image, or nowhere, to -1.
LaneInts cells(const Lanes& px) {
  constexpr float kPerCell = 1.0F / DirectionMap::kCellPx;
  constexpr float kFar = 1e6F;  // no conversion may leave the range of integers
  const Lanes inside = px >= 0 ? px * kPerCell : Lanes{} - 1;
  return __builtin_convertvector(inside < kFar ? inside : Lanes{} + kFar, LaneInts);
}

}  // namespace

/// The sum over samples, where any segment of about a sample's direction and place is a hit.
float Evidence::score_at_most(const ModelSketch& model, const Transform& pose,
                              bool two_samples) const {
  const float two_px = two_samples ? 2 * static_cast<float>(options_.sample_px) : 1e9F;
  // The two samples of an edge are nearly one.
  const float hopeless = two_samples ? 2 * kHopeless : kHopeless;
  float sum = 0;
  std::size_t first = 0;
  for (const LaneRig& rig : rigs_) {
    Seen& seen = scratch();
    seen.look(ViewLanes(rig, pose), model);
    for (const ModelSketch::Edge& e : model.edges) {
      const SeenEdge edge(seen, e);
      if (!any(edge.asked)) continue;
      const auto& [p, q, dx, dy, squared, asked] = edge;
      const LaneInts two = asked & (squared >= two_px * two_px);
      const Lanes turn = asked ? DirectionBins::places(dx, dy) : Lanes{};
      const LaneInts bins = __builtin_convertvector(turn, LaneInts) % DirectionBins::kCount;
      const auto look = [&](const Lanes& x, const Lanes& y, const LaneInts& mask) {
        const LaneInts columns = cells(x), rows = cells(y);
        for (std::size_t lane = 0; lane < rig.count; ++lane) {
          const DirectionMap& map = maps_[first + lane];
          const auto column = static_cast<unsigned>(columns[lane]);
          const auto row = static_cast<unsigned>(rows[lane]);
          if (!mask[lane] || column >= map.columns() || row >= map.rows()) continue;
          sum += odds_[first + lane][map.cell(column, row) >> bins[lane] & 1];
        }
      };
      const Lanes at = two ? Lanes{} + 0.25F : Lanes{} + 0.5F;
      look(p.x + at * dx, p.y + at * dy, asked);
      if (two_samples) look(q.x - at * dx, q.y - at * dy, two);
      if (sum < -hopeless) return sum;
    }
    first += rig.count;
  }
  return sum;
}

bool Evidence::hopeless(const ModelSketch& model, const Transform& pose) const {
  // What fails when it is judged kindly fails.
  if (score_at_most(model, pose, false) <= 0) return true;
  double sum = 0;
  visit(model, pose, 1, [&](const Sample& s) {
    sum += s.segment >= 0 ? log_hit_[s.view] : log_miss_[s.view];
    return sum >= -kHopeless;
  });
  return sum <= 0;
}

void Evidence::ask_along(const Vector3d& x, const Vector3d& d, const std::vector<double>& from_mm,
                         double length_mm, Spoke& out) const {
  out.sums_.clear();
  for (std::size_t v = 0; v < views_.size(); ++v) {
    if (from_mm[v] >= length_mm) continue;
    const auto& P = views_[v].ideal.matrix();
    const Vector3d at = P.leftCols<3>() * x + P.col(3), along = P.leftCols<3>() * d;
    const double u = at.x() / at.z(), w = at.y() / at.z();
    // px per mm at x; the image of a line keeps its direction.
    const double du = (along.x() - u * along.z()) / at.z();
    const double dw = (along.y() - w * along.z()) / at.z();
    const double px_per_mm = std::sqrt(du * du + dw * dw);
    if (!(at.z() > kNearestMm) || px_per_mm * length_mm < kMinLengthPx) continue;
    const double step_mm = options_.sample_px / px_per_mm;
    if (out.sums_.empty()) {
      out.steps_per_mm_ = static_cast<float>(2 / step_mm);
      out.sums_.assign(static_cast<std::size_t>(2 * length_mm / step_mm) + 2, 0.0F);
    }
    const unsigned bin = DirectionBins::bin(static_cast<float>(du), static_cast<float>(dw));
    for (double s = 0.5 * step_mm; s < length_mm; s += step_mm) {
      if (s < from_mm[v]) continue;
      const double depth = at.z() + s * along.z();
      if (!(depth > kNearestMm)) break;
      const double px = (at.x() + s * along.x()) / depth, py = (at.y() + s * along.y()) / depth;
      if (!maps_[v].covers(px, py)) break;
      const auto place = static_cast<std::size_t>(s * out.steps_per_mm_) + 1;
      out.sums_[std::min(place, out.sums_.size() - 1)] += odds_[v][maps_[v].at(px, py) >> bin & 1];
    }
  }
  for (std::size_t i = 1; i < out.sums_.size(); ++i) out.sums_[i] += out.sums_[i - 1];
}

void Evidence::refine(const ModelSketch& model, Transform& pose, int max_samples) const {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  const Vector3d centre = pose * model.vertex_mean;
  visit(model, pose, max_samples, [&](const Sample& s) {
    if (s.segment < 0) return true;
    const ViewLines& view = views_[s.view];
    const Eigen::Vector3f& x0 = model.vertices[static_cast<std::size_t>(s.edge->v0)];
    const Eigen::Vector3f& x1 = model.vertices[static_cast<std::size_t>(s.edge->v1)];
    const Vector3d x = pose * (x0 + s.along * (x1 - x0)).cast<double>();
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
