// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recognition/object_evidence.hpp"

namespace trihedron {

/// Pieces shorter than this say nothing of their own: contours are rounded at junctions, px.
inline constexpr double kShortPx = 10;
/// Independent answers that one piece can give about its model edge at most.
inline constexpr double kAnswers = 5;

/// Likelihood of a piece whose edge is as predicted and has contrast.
double likelihood_present(const PieceEvidence& piece);
/// Likelihood of a piece whose edge is not where it is predicted.
double likelihood_elsewhere(const PieceEvidence& piece);
/// Likelihood of a piece of an object that is there.
double likelihood_there(const PieceEvidence& piece);
/// Likelihood of a piece when a share `elsewhere` of the edges lies elsewhere.
double likelihood_partly(const PieceEvidence& piece, double elsewhere);

}  // namespace trihedron
