// SPDX-License-Identifier: Apache-2.0
#include "recognition/visibility.hpp"

#include <algorithm>
#include <optional>

#include "recognition/projected_model.hpp"

namespace trihedron {
namespace {

using Interval = std::pair<double, double>;

/// Pieces shorter than this fraction of their model edge are rounding.
constexpr double kShortestPiece = 1e-6;
/// Behind a surface of the same object, mm: above rounding, below any feature of a model.
constexpr double kSelfOcclusionMm = 1e-3;

/// A model edge on its way through the hidden-line test.
struct Candidate {
  Eigen::Vector3d p0, p1;  // camera frame
  Eigen::Vector2d a, b;    // ideal coordinates
  bool pinhole = true;

  /// Fraction of the 3D edge at fraction t of its image: 1/z is linear in the image.
  double from_image(double t) const {
    if (!pinhole) return t;
    return t * p0.z() / (p1.z() + t * (p0.z() - p1.z()));
  }
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The part of the edge behind the surface's plane by more than `margin` mm.
std::optional<Interval> behind_plane(const Candidate& edge, const Eigen::Vector3d& normal,
                                     double offset, double margin) {
  const double d0 = normal.dot(edge.p0) - offset + margin;
  const double d1 = normal.dot(edge.p1) - offset + margin;
  if (d0 >= 0 && d1 >= 0) return std::nullopt;
  if (d0 < 0 && d1 < 0) return Interval{0, 1};
  const double s = d0 / (d0 - d1);
  return d0 < 0 ? Interval{0, s} : Interval{s, 1};
}

/// Where the edge's image crosses the surface's boundary, as sorted fractions of the image.
void boundary_crossings(const Candidate& edge, const ProjectedModel& other, int surface,
                        std::vector<double>& crossings) {
  crossings.assign(1, 0.0);
  const Eigen::Vector2d direction = edge.b - edge.a;
  for (const std::vector<int>& loop : other.model->surfaces[surface].loops) {
    Eigen::Vector2d q0 = other.ideal[loop.back()];
    double c0 = cross(direction, q0 - edge.a);
    for (int v : loop) {
      const Eigen::Vector2d q1 = other.ideal[v];
      const double c1 = cross(direction, q1 - edge.a);
      if ((c0 > 0) != (c1 > 0)) {
        const Eigen::Vector2d q = q0 + c0 / (c0 - c1) * (q1 - q0);
        const double t = direction.dot(q - edge.a) / direction.squaredNorm();
        if (t > 0 && t < 1) crossings.push_back(t);
      }
      q0 = q1;
      c0 = c1;
    }
  }
  crossings.push_back(1.0);
  std::sort(crossings.begin(), crossings.end());
}

bool covers(const ProjectedModel& other, int surface, const Eigen::Vector2d& x) {
  bool inside = false;
  for (const std::vector<int>& loop : other.model->surfaces[surface].loops) {
    Eigen::Vector2d q0 = other.ideal[loop.back()];
    for (int v : loop) {
      const Eigen::Vector2d q1 = other.ideal[v];
      if ((q0.y() > x.y()) != (q1.y() > x.y())) {
        inside ^= q0.x() + (x.y() - q0.y()) / (q1.y() - q0.y()) * (q1.x() - q0.x()) > x.x();
      }
      q0 = q1;
    }
  }
  return inside;
}

bool apart(const ProjectedModel::Box& a, const ProjectedModel::Box& b) {
  return (a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any();
}

/// Adds to `hidden` what one surface hides of the edge.
void hide_behind(const Candidate& edge, const ProjectedModel& other, int surface, double margin,
                 std::vector<double>& crossings, std::vector<Interval>& hidden) {
  const auto behind = behind_plane(edge, other.normals[surface], other.offsets[surface], margin);
  if (!behind) return;
  boundary_crossings(edge, other, surface, crossings);
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const double s0 = std::max(edge.from_image(crossings[i]), behind->first);
    const double s1 = std::min(edge.from_image(crossings[i + 1]), behind->second);
    if (s1 - s0 <= kShortestPiece) continue;
    // The middle decides: an end often lies on the boundary, where rounding would decide.
    const double t = 0.5 * (crossings[i] + crossings[i + 1]);
    if (covers(other, surface, edge.a + t * (edge.b - edge.a))) hidden.push_back({s0, s1});
  }
}

/// The complement of `hidden` in [0, 1].
std::vector<Interval> visible_parts(std::vector<Interval>& hidden) {
  std::sort(hidden.begin(), hidden.end());
  std::vector<Interval> parts;
  double start = 0;
  hidden.push_back({1, 1});
  for (const Interval& h : hidden) {
    if (h.first - start > kShortestPiece) parts.push_back({start, h.first});
    start = std::max(start, h.second);
  }
  return parts;
}

/// The type of an edge and its visible surfaces, nothing when no adjacent surface shows it.
std::optional<VisibleEdge> classify(const ProjectedModel& projected, int object, int index) {
  const ModelEdge& edge = projected.model->edges[index];
  const bool left = projected.front[edge.left], right = projected.front[edge.right];
  // At a concave edge with one surface turned away, the solid itself hides the edge.
  if ((!left && !right) || (!edge.convex && left != right)) return std::nullopt;
  VisibleEdge out;
  out.object = object;
  out.edge = index;
  out.type = left && right ? EdgeType::kCrease : EdgeType::kSilhouette;
  out.surface = left ? edge.left : edge.right;
  if (left && right) out.other_surface = edge.right;
  return out;
}

void finish(const Camera& camera, const PlacedModel& placed, const Interval& part,
            VisibleEdge& out) {
  const ModelEdge& edge = placed.model->edges[out.edge];
  const Eigen::Vector3d v0 = placed.world_from_model * placed.model->mesh.vertices[edge.v0];
  const Eigen::Vector3d v1 = placed.world_from_model * placed.model->mesh.vertices[edge.v1];
  std::tie(out.s0, out.s1) = part;
  out.x0_in_world = v0 + out.s0 * (v1 - v0);
  out.x1_in_world = v0 + out.s1 * (v1 - v0);
  out.x0 = camera.project(out.x0_in_world);
  out.x1 = camera.project(out.x1_in_world);
  const Eigen::Vector2d along = out.x1 - out.x0;
  out.length_px = along.norm();
  // Seen from outside the left surface lies left of v0 -> v1; with y down, left of (dx, dy) is
  // (dy, -dx), so away from it is (-dy, dx).
  const double side = out.surface == edge.left ? 1 : -1;
  out.normal = side * Eigen::Vector2d(-along.y(), along.x()) / std::max(out.length_px, 1e-12);
}

}  // namespace

std::vector<VisibleEdge> visible_edges(const Camera& camera,
                                       const std::vector<PlacedModel>& objects, int only) {
  std::vector<ProjectedModel> projected;
  for (const PlacedModel& placed : objects) projected.push_back(project_model(camera, placed));
  std::vector<VisibleEdge> out;
  std::vector<Interval> hidden;
  std::vector<double> crossings;
  for (int object = 0; object < static_cast<int>(objects.size()); ++object) {
    if (only >= 0 && object != only) continue;
    const ProjectedModel& own = projected[object];
    for (int index = 0; index < static_cast<int>(own.model->edges.size()); ++index) {
      auto visible = classify(own, object, index);
      if (!visible) continue;
      const ModelEdge& edge = own.model->edges[index];
      const Candidate candidate{own.x_in_camera[edge.v0], own.x_in_camera[edge.v1],
                                own.ideal[edge.v0], own.ideal[edge.v1],
                                camera.projection == Camera::Projection::kPinhole};
      const ProjectedModel::Box box{candidate.a.cwiseMin(candidate.b),
                                    candidate.a.cwiseMax(candidate.b)};
      hidden.clear();
      for (const ProjectedModel& other : projected) {
        if (apart(box, other.box)) continue;
        const bool self = &other == &own;
        for (int s = 0; s < static_cast<int>(other.front.size()); ++s) {
          if (!other.front[s] || (self && (s == edge.left || s == edge.right))) continue;
          if (apart(box, other.boxes[s])) continue;
          hide_behind(candidate, other, s, self ? kSelfOcclusionMm : kContactMm, crossings, hidden);
        }
      }
      for (const Interval& part : visible_parts(hidden)) {
        finish(camera, objects[object], part, *visible);
        out.push_back(*visible);
      }
    }
  }
  return out;
}

}  // namespace trihedron
