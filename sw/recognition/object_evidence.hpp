// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/refinement.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

/// What the contour stream says of one visible piece of a predicted edge.
struct PieceEvidence {
  int view = 0;
  int edge = 0;     ///< index into Model::edges
  int surface = 0;  ///< as in VisibleEdge
  EdgeType type = EdgeType::kSilhouette;
  double length_px = 0;
  int points = 0;        ///< asked, kEvidenceStepPx apart
  double found = 0;      ///< share of points where an edge lies where it is predicted
  double displaced = 0;  ///< share of points with nothing there, but a straight, nearly parallel
                         ///< edge beside it that no predicted line explains: the object has its
                         ///< edge elsewhere
  double flat = 0;       ///< share of points with neither: hidden, or no contrast
  double weak = 0;  ///< share of points with too little contrast for a contour, where the piece as
                    ///< a whole does show a step
  double offset_px = 0;        ///< median of the found points' distances, along `normal`: to the
                               ///< contour's pixel where there is one, or exact if asked for
  double displacement_px = 0;  ///< median of the displaced points' distances, along `normal`
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();          ///< as in VisibleEdge
  Eigen::Vector3d middle_in_world = Eigen::Vector3d::Zero();  ///< mm
};

inline constexpr double kEvidenceStepPx = 4;

/// The evidence for one object, occluded by the others, in all views.
struct ObjectEvidence {
  std::vector<PieceEvidence> pieces;
  double found_px = 0, displaced_px = 0, flat_px = 0;  ///< summed over the pieces
};

/// Edges beside a predicted one count as displaced from here on, mm: 10 % of a feature of 20 mm.
inline constexpr double kLeastDisplacementMm = 2;
/// Edges beside a predicted one are looked for up to this share of the model's diameter.
inline constexpr double kSimilarShapes = 0.12;

/// Collects the evidence for `objects[index]`. The image lines of all `objects` count as
/// explained; a contour where an object with a smaller index has a line proves nothing here.
/// Exact offsets take a look at the gradient of every point, nothing else depends on them.
ObjectEvidence collect_evidence(const std::vector<FieldView>& views,
                                const std::vector<PlacedModel>& objects, int index,
                                bool exact_offsets = false);

}  // namespace trihedron
