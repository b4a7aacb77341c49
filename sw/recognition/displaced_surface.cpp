// SPDX-License-Identifier: Apache-2.0
#include "recognition/displaced_surface.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "recognition/piece_likelihood.hpp"

namespace trihedron {
namespace {

/// How the line of a surface's edge moves in the image, px, when the surface moves 1 mm outwards.
double shift_per_mm(const FieldView& view, const PlacedModel& placed, const PieceEvidence& piece,
                    int surface) {
  const ModelEdge& edge = placed.model->edges[piece.edge];
  const Model& model = *placed.model;
  const Eigen::Vector3d along =
      (model.mesh.vertices[edge.v1] - model.mesh.vertices[edge.v0]).normalized();
  const int other = edge.left == surface ? edge.right : edge.left;
  // The edge stays in the other surface's plane.
  const Eigen::Vector3d in_other = model.surfaces[other].normal.cross(along);
  const double outwards = model.surfaces[surface].normal.dot(in_other);
  if (std::abs(outwards) < 0.2) return 0;
  const Eigen::Vector3d move = placed.world_from_model.R * (in_other / outwards);
  return piece.normal.dot(view.camera->projection_jacobian(piece.middle_in_world) * move);
}

}  // namespace

DisplacedSurface displaced_surface(const std::vector<FieldView>& views, const PlacedModel& placed,
                                   const ObjectEvidence& evidence, int surface) {
  struct Vote {
    const PieceEvidence* piece;
    double px_per_mm;
  };
  constexpr double kInformative = 0.3;  // of a full shift: less says nothing of the surface
  constexpr double kSmallestMm = kLeastDisplacementMm;
  std::vector<Vote> votes;
  std::map<int, bool> flat_in_view;
  for (const PieceEvidence& piece : evidence.pieces) {
    const ModelEdge& edge = placed.model->edges[piece.edge];
    if ((edge.left != surface && edge.right != surface) || piece.length_px < kShortPx) continue;
    const double shift = shift_per_mm(views[piece.view], placed, piece, surface);
    const double full = views[piece.view].camera->px_per_mm_at(piece.middle_in_world);
    if (std::abs(shift) < kInformative * full) continue;
    // Flat pieces of one view have one cause.
    if (piece.flat >= 0.5 && std::exchange(flat_in_view[piece.view], true)) continue;
    votes.push_back({&piece, shift});
  }
  DisplacedSurface best;
  best.surface = surface;
  best.log_odds = -1e9;
  for (const Vote& leader : votes) {
    if (leader.piece->displaced < 0.5) continue;
    const double mm = leader.piece->displacement_px / leader.px_per_mm;
    if (std::abs(mm) < kSmallestMm || std::abs(mm) > kSimilarShapes * placed.model->diameter)
      continue;
    double log = 0;
    for (const Vote& vote : votes) {
      const double expected = mm * vote.px_per_mm, got = vote.piece->displacement_px;
      // A shape scaled in one direction turns its surfaces too: a quarter is left to that.
      const bool agrees = std::abs(got - expected) < 2 + 0.25 * std::abs(expected);
      PieceEvidence piece = *vote.piece;
      if (!agrees) std::swap(piece.displaced, piece.flat);
      log += std::log(0.1 * likelihood_present(piece) + 0.9 * likelihood_elsewhere(piece)) -
             std::log(likelihood_there(*vote.piece));
    }
    if (log > best.log_odds) {
      best.log_odds = log;
      best.outwards_mm = mm;
    }
  }
  return best;
}

}  // namespace trihedron
