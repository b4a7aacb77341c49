// SPDX-License-Identifier: Apache-2.0
#include "recognition/lookalikes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recognition/symmetry.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;

/// Two edges coincide when they are nearer than this share of the diameter: about the 3 px within
/// which contours belong to a predicted line, for an object 150 px wide.
constexpr double kCoincide = 0.02;
/// Alike: so much of the edge length coincides. Below, the views differ so widely that no mistake
/// is possible ...
constexpr double kAlike = 0.5;
/// ... but with mirror images, when much is hidden: a skew frustum shares little more than its
/// base.
constexpr double kAlikeMirrored = 0.3;
/// Motions with fewer common vertices than this share are not looked at closely.
constexpr double kAlikeVertices = 0.3;

double distance_to_edge(const Model& model, const ModelEdge& edge, const Vector3d& x) {
  const Vector3d& a = model.mesh.vertices[edge.v0];
  const Vector3d along = model.mesh.vertices[edge.v1] - a;
  const double t = std::clamp(along.dot(x - a) / along.squaredNorm(), 0.0, 1.0);
  return (x - a - t * along).norm();
}

bool on_some_edge(const Model& model, const Vector3d& x, double within) {
  return std::any_of(model.edges.begin(), model.edges.end(), [&](const ModelEdge& edge) {
    return distance_to_edge(model, edge, x) < within;
  });
}

/// Share of the moved model's edge length that lies on edges of `onto`.
double shared_edges(const Model& model, const Transform& motion, const Model& onto) {
  double shared = 0, all = 0;
  for (const ModelEdge& edge : model.edges) {
    for (const double s : {1 / 6., 1 / 2., 5 / 6.}) {
      const Vector3d x = (1 - s) * model.mesh.vertices[edge.v0] + s * model.mesh.vertices[edge.v1];
      all += edge.length;
      if (on_some_edge(onto, motion * x, kCoincide * onto.diameter)) shared += edge.length;
    }
  }
  return shared / all;
}

double shared_vertices(const Model& model, const Transform& motion, const Model& onto) {
  const double squared = kCoincide * onto.diameter * kCoincide * onto.diameter;
  const auto shared =
      std::count_if(model.mesh.vertices.begin(), model.mesh.vertices.end(), [&](const Vector3d& v) {
        const Vector3d x = motion * v;
        return std::any_of(onto.mesh.vertices.begin(), onto.mesh.vertices.end(),
                           [&](const Vector3d& w) { return (w - x).squaredNorm() < squared; });
      });
  return static_cast<double>(shared) / static_cast<double>(model.mesh.vertices.size());
}

/// Origin at the start of an edge, x along it, z along the normal of the surface on its left; or
/// of the edge walked backwards.
Transform frame(const Model& model, const ModelEdge& edge, bool backwards) {
  const Vector3d& from = model.mesh.vertices[backwards ? edge.v1 : edge.v0];
  const Vector3d& to = model.mesh.vertices[backwards ? edge.v0 : edge.v1];
  const Vector3d x = (to - from).normalized();
  const Vector3d z = model.surfaces[backwards ? edge.right : edge.left].normal;
  Transform out;
  out.R << x, z.cross(x), z;
  out.t = from;
  return out;
}

bool same_motion(const Transform& a, const Transform& b, double within) {
  // Of rotations, a radius' length apart at most `within`.
  return (a.t - b.t).norm() < within && (a.R - b.R).norm() < kCoincide;
}

/// The motions that put an edge of `model` onto an equal one of `onto`, each once.
std::vector<Transform> edge_motions(const Model& model, const Model& onto) {
  const double within = kCoincide * onto.diameter;
  std::vector<Transform> out;
  for (const ModelEdge& to : onto.edges) {
    const Transform target = frame(onto, to, false);
    for (const ModelEdge& from : model.edges) {
      if (std::abs(from.length - to.length) > within) continue;
      for (const bool backwards : {false, true}) {
        const Transform motion = target * frame(model, from, backwards).inverse();
        const bool known = std::any_of(out.begin(), out.end(), [&](const Transform& other) {
          return same_motion(other, motion, within);
        });
        if (!known) out.push_back(motion);
      }
    }
  }
  return out;
}

std::vector<Transform> alike(const Model& model, const Model& onto, double least_share) {
  struct Scored {
    double share;
    Transform motion;
  };
  std::vector<Scored> scored;
  for (const Transform& motion : edge_motions(model, onto)) {
    if (shared_vertices(model, motion, onto) < kAlikeVertices) continue;
    const double share = shared_edges(model, motion, onto);
    if (share > least_share) scored.push_back({share, motion});
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const Scored& a, const Scored& b) { return a.share > b.share; });
  std::vector<Transform> out;
  for (const Scored& s : scored) out.push_back(s.motion);
  return out;
}

void keep_first(std::vector<Transform>& motions) {
  if (motions.size() > kLookalikes) motions.resize(kLookalikes);
}

}  // namespace

Model mirror_image(const Model& model) {
  const auto flip = [](Vector3d& x) { x.x() = -x.x(); };
  Model out = model;
  for (Vector3d& v : out.mesh.vertices) flip(v);
  for (auto& triangle : out.mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (Surface& surface : out.surfaces) {
    flip(surface.normal);
    flip(surface.centroid);
    for (auto& loop : surface.loops) std::reverse(loop.begin(), loop.end());
  }
  for (ModelEdge& edge : out.edges) std::swap(edge.left, edge.right);
  for (Transform& symmetry : out.symmetries) {
    symmetry.R.row(0) *= -1;
    symmetry.R.col(0) *= -1;
    flip(symmetry.t);
  }
  return out;
}

Model bounding_block(const Model& model) {
  Vector3d low = model.mesh.vertices[0], high = low;
  for (const Vector3d& v : model.mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  Mesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.emplace_back((k & 1 ? high : low).x(), (k & 2 ? high : low).y(),
                               (k & 4 ? high : low).z());
  }
  // Corner k's bits say which end of x, y and z it lies at.
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return build_model(model.id, "block around " + model.name, mesh);
}

Lookalikes find_lookalikes(const Model& model) {
  Lookalikes out;
  Model block = bounding_block(model);
  if (congruences(block, model).empty()) out.block = std::move(block);
  for (const Transform& motion : alike(model, model, kAlike)) {
    const double within = kCoincide * model.diameter;
    const bool symmetric =
        same_motion(motion, {}, within) ||
        std::any_of(model.symmetries.begin(), model.symmetries.end(),
                    [&](const Transform& s) { return same_motion(motion, s, within); });
    if (!symmetric) out.turned.push_back(motion);
  }
  keep_first(out.turned);
  Model mirrored = mirror_image(model);
  if (!congruences(mirrored, model).empty()) return out;
  out.mirrored_onto = alike(mirrored, model, kAlikeMirrored);
  keep_first(out.mirrored_onto);
  out.mirrored = std::move(mirrored);
  return out;
}

}  // namespace trihedron
