// SPDX-License-Identifier: Apache-2.0
#include "recognition/similar_shapes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "recognition/surface_attributes.hpp"
#include "recognition/verification.hpp"

namespace trihedron {
namespace {

using Eigen::Vector3d;
using Motion = std::vector<Vector3d>;  // of a model's vertices, model frame, mm

/// A change of shape, by one parameter.
struct Change {
  Motion per_unit;
  double least = 0, most = 0;  ///< |parameter|
  int surface = -1;            ///< that moves by the parameter in mm; -1: stretched by parameter
};

/// Shapes differ by at least this much of a dimension: less is the model's own tolerance.
constexpr double kLeastStretch = 0.03, kMostStretch = 0.25;
/// A piece shows a change when its edge moves by this part of what it would move at most.
constexpr double kShows = 0.3;
/// A contour within this of a predicted line is found, px; as in the evidence.
constexpr double kFoundPx = 1.8;
/// A shape that seems to explain less than this part of what the model explains is not tried.
constexpr double kPromise = 0.7;

void add_axis(const Vector3d& axis, std::vector<Vector3d>& axes) {
  constexpr double kSame = 0.98;  // cosine
  const bool known = std::any_of(axes.begin(), axes.end(), [&](const Vector3d& other) {
    return std::abs(axis.dot(other)) > kSame;
  });
  if (!known) axes.push_back(axis);
}

/// The axes of a model's frame, and what its symmetries make of them: a pose is known but for
/// those, and a stretched shape has them no more.
std::vector<Vector3d> frame_axes(const Model& model) {
  std::vector<Vector3d> axes;
  for (int k = 0; k < 3; ++k) add_axis(Vector3d::Unit(k), axes);
  for (const Transform& symmetry : model.symmetries) {
    for (int k = 0; k < 3; ++k) add_axis(symmetry.R.col(k), axes);
  }
  return axes;
}

/// Unit directions along which a model may be longer or shorter: its frame's, and those of its
/// largest surface and of the largest one across it, where they differ.
std::vector<Vector3d> stretch_axes(const Model& model) {
  std::vector<Vector3d> axes = frame_axes(model);
  constexpr double kAcross = 0.2;  // cosine
  const auto smaller = [](const Surface& a, const Surface& b) { return a.area < b.area; };
  const Vector3d first =
      std::max_element(model.surfaces.begin(), model.surfaces.end(), smaller)->normal;
  const Surface* second = nullptr;
  for (const Surface& s : model.surfaces) {
    if (std::abs(s.normal.dot(first)) < kAcross && (!second || smaller(*second, s))) second = &s;
  }
  add_axis(first, axes);
  if (second) {
    add_axis(second->normal, axes);
    add_axis(first.cross(second->normal).normalized(), axes);
  }
  return axes;
}

/// The model stretched along an axis, its points `rest` mm along that at rest.
Change stretch(const Model& model, const Vector3d& axis, double rest) {
  Change out{{}, kLeastStretch, kMostStretch, -1};
  for (const Vector3d& v : model.mesh.vertices) {
    out.per_unit.push_back((axis.dot(v) - rest) * axis);
  }
  return out;
}

/// Where a model begins and ends along an axis, mm.
std::pair<double, double> ends_along(const Model& model, const Vector3d& axis) {
  double low = 1e300, high = -1e300;
  for (const Vector3d& v : model.mesh.vertices) {
    low = std::min(low, axis.dot(v));
    high = std::max(high, axis.dot(v));
  }
  return {low, high};
}

/// Stretches along one axis, each with another of the model's places at rest.
void add_stretches(const Model& model, const Vector3d& axis, std::vector<Change>& out) {
  constexpr double kSamePlaceMm = 1;
  std::vector<double> places;
  for (const Vector3d& v : model.mesh.vertices) places.push_back(axis.dot(v));
  std::sort(places.begin(), places.end());
  places.push_back(0.5 * (places.front() + places.back()));
  double last = -1e300;
  for (const double rest : places) {
    if (std::abs(rest - last) < kSamePlaceMm) continue;
    last = rest;
    out.push_back(stretch(model, axis, rest));
  }
}

/// The surface moved outwards by 1 mm: its corners stay in the planes of their other surfaces.
Change moved_surface(const Model& model, int surface) {
  Change out{Motion(model.mesh.vertices.size(), Vector3d::Zero()), kLeastDisplacementMm,
             kSimilarShapes * model.diameter, surface};
  const Vector3d& normal = model.surfaces[surface].normal;
  for (const std::vector<int>& loop : model.surfaces[surface].loops) {
    for (const int v : loop) {
      // Least squares, as little motion as possible: other planes stay, this one moves.
      Eigen::Matrix3d A = 100 * normal * normal.transpose() + 1e-3 * Eigen::Matrix3d::Identity();
      for (const int e : model.vertex_edges[v]) {
        for (const int s : {model.edges[e].left, model.edges[e].right}) {
          const Vector3d& n = model.surfaces[s].normal;
          if (s != surface) A += n * n.transpose();
        }
      }
      out.per_unit[v] = A.ldlt().solve(Vector3d(100 * normal));
    }
  }
  return out;
}

std::vector<Change> changes(const Model& model) {
  std::vector<Change> out;
  for (const Vector3d& axis : stretch_axes(model)) add_stretches(model, axis, out);
  for (int s = 0; s < static_cast<int>(model.surfaces.size()); ++s) {
    out.push_back(moved_surface(model, s));
  }
  return out;
}

/// A piece of evidence, ready to be asked about changes.
struct Piece {
  const PieceEvidence* evidence;
  double answers, hit, miss;
  Vector3d px_per_mm;  ///< of its edge across itself, by a motion of its middle in the model frame
  double along;        ///< of the middle from v0 to v1
};

std::vector<Piece> prepare(const std::vector<FieldView>& views,
                           const std::vector<SpreadMap>& chance, const PlacedModel& placed,
                           const ObjectEvidence& evidence) {
  std::vector<Piece> out;
  const Transform model_from_world = placed.world_from_model.inverse();
  for (const PieceEvidence& piece : evidence.pieces) {
    const ModelEdge& edge = placed.model->edges[piece.edge];
    const Vector3d& v0 = placed.model->mesh.vertices[edge.v0];
    const Vector3d run = placed.model->mesh.vertices[edge.v1] - v0;
    const double along = run.dot(model_from_world * piece.middle_in_world - v0) / run.squaredNorm();
    const Vector3d across =
        views[piece.view].camera->projection_jacobian(piece.middle_in_world).transpose() *
        piece.normal;
    const PieceOdds odds = piece_odds(chance, piece);
    out.push_back({&piece, odds.answers, odds.hit, odds.miss,
                   placed.world_from_model.R.transpose() * across, along});
  }
  return out;
}

double shift_px(const Piece& piece, const Model& model, const Motion& motion) {
  const ModelEdge& edge = model.edges[piece.evidence->edge];
  return piece.px_per_mm.dot((1 - piece.along) * motion[edge.v0] + piece.along * motion[edge.v1]);
}

/// The log likelihood ratio against chance that the changed shape promises.
double promised(const std::vector<Piece>& pieces, const std::vector<double>& shifts,
                double parameter) {
  double sum = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PieceEvidence& e = *pieces[i].evidence;
    const double shift = parameter * shifts[i];
    double found = std::abs(shift) < kFoundPx ? e.found : 0;
    // Part of a change may turn the edge as well: a quarter is left to that.
    if (e.displaced > 0 && std::abs(e.displacement_px - shift) < 2 + 0.25 * std::abs(shift)) {
      found += e.displaced;
    }
    sum += pieces[i].answers * (found * pieces[i].hit + (1 - found - e.weak) * pieces[i].miss);
  }
  return sum;
}

struct Promise {
  double score;
  std::size_t change;
  double parameter;
};

/// What each displaced piece would have a change be.
void promises_of(const Model& model, const std::vector<Piece>& pieces, const Change& change,
                 std::size_t index, double enough, std::vector<Promise>& out) {
  std::vector<double> shifts;
  double largest = 0;
  for (const Piece& piece : pieces) {
    shifts.push_back(shift_px(piece, model, change.per_unit));
    largest = std::max(largest, std::abs(shifts.back()));
  }
  Promise best{enough, index, 0};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].evidence->displaced < 0.5 || std::abs(shifts[i]) < kShows * largest) continue;
    const double parameter = pieces[i].evidence->displacement_px / shifts[i];
    if (std::abs(parameter) < change.least || std::abs(parameter) > change.most) continue;
    const double score = promised(pieces, shifts, parameter);
    if (score > best.score) best = {score, index, parameter};
  }
  if (best.parameter != 0) out.push_back(best);
}

SimilarShape realize(const PlacedModel& placed, const Change& change, double parameter) {
  std::vector<Vector3d> vertices = placed.model->mesh.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] += parameter * change.per_unit[v];
  char text[80];
  if (change.surface < 0) {
    std::snprintf(text, sizeof text, "one %.0f %% %s", 100 * std::abs(parameter),
                  parameter > 0 ? "longer" : "shorter");
  } else {
    std::snprintf(text, sizeof text, "surface %d of the object lies %+.1f mm off the model's",
                  change.surface, parameter);
  }
  return {reshaped(*placed.model, vertices), placed.world_from_model, text};
}

}  // namespace

Model reshaped(const Model& model, const std::vector<Vector3d>& vertices) {
  Model out = model;
  out.mesh.vertices = vertices;
  for (int s = 0; s < static_cast<int>(out.surfaces.size()); ++s) {
    const SurfaceAttributes attributes = surface_attributes(out, s);
    if (attributes.area == 0) continue;
    Surface& surface = out.surfaces[s];
    surface.normal = attributes.normal;
    surface.centroid = attributes.centroid;
    surface.offset = surface.normal.dot(surface.centroid);
    surface.area = attributes.area;
    surface.perimeter = attributes.perimeter;
  }
  for (ModelEdge& edge : out.edges) edge.length = (vertices[edge.v1] - vertices[edge.v0]).norm();
  return out;
}

SimilarShapes similar_shapes(const std::vector<FieldView>& views,
                             const std::vector<SpreadMap>& chance, const PlacedModel& placed,
                             const ObjectEvidence& evidence) {
  const bool displaced =
      std::any_of(evidence.pieces.begin(), evidence.pieces.end(),
                  [](const PieceEvidence& piece) { return piece.displaced >= 0.5; });
  if (!displaced) return {};
  const std::vector<Piece> pieces = prepare(views, chance, placed, evidence);
  const std::vector<double> none(pieces.size(), 0.0);
  const double enough = kPromise * promised(pieces, none, 0);
  const std::vector<Change> all = changes(*placed.model);
  std::vector<Promise> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    promises_of(*placed.model, pieces, all[i], i, enough, found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Promise& a, const Promise& b) { return a.score > b.score; });
  if (found.size() > kSimilarTried) found.resize(kSimilarTried);
  SimilarShapes out;
  out.log_choices = std::log(static_cast<double>(all.size()));
  for (const Promise& p : found) out.shapes.push_back(realize(placed, all[p.change], p.parameter));
  return out;
}

SimilarShapes stretched_shapes(const PlacedModel& placed) {
  SimilarShapes out;
  for (const Vector3d& axis : frame_axes(*placed.model)) {
    const auto [low, high] = ends_along(*placed.model, axis);
    for (const double by : {kSimilarStretch, -kSimilarStretch}) {
      for (const double rest : {0.5 * (low + high), low, high}) {
        out.shapes.push_back(realize(placed, stretch(*placed.model, axis, rest), by));
      }
    }
  }
  out.log_choices = std::log(static_cast<double>(out.shapes.size()));
  return out;
}

}  // namespace trihedron
