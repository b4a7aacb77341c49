// SPDX-License-Identifier: Apache-2.0
#include "recognition/piece_likelihood.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trihedron {
namespace {

/// Probabilities of an answer (found, displaced, flat) at a point of a predicted edge, and of a
/// faint step along the whole piece.
using Answers = std::array<double, 4>;
/// ... where the edge is as predicted and has contrast,
constexpr Answers kPresent = {0.96, 0.01, 0.03, 0.03};
/// ... where the surfaces on both sides are nearly equally bright,
constexpr Answers kWeak = {0.15, 0.05, 0.80, 0.5};
/// ... where the edge is elsewhere and seen there,
constexpr Answers kBeside = {0.10, 0.75, 0.15, 0.02};
/// ... where it is elsewhere, out of reach, or something unknown hides it.
constexpr Answers kNothing = {0.10, 0.05, 0.85, 0.05};
/// Shares of weak pieces, of pieces that something unknown hides, and of pieces beside which a
/// shadow lies just like an edge, of an object that is there: from the physics of diffuse surfaces,
/// where a contrast of less than 2 % of the range has about the first probability; 0.2 to 0.4 % of
/// the pieces of true objects have a parallel edge beside them instead of their own.
constexpr double kWeakShare = 0.06, kHiddenShare = 0.035, kShadowShare = 0.008;
/// Of edges that lie elsewhere, so many are seen beside their predicted place: the rest lies out of
/// reach or has no contrast.
constexpr double kSeenBeside = 0.7;

double likelihood(const PieceEvidence& piece, const Answers& p) {
  const double n = std::min<double>(piece.points, kAnswers);
  return std::exp(n * (piece.found * std::log(p[0]) + piece.displaced * std::log(p[1]) +
                       piece.flat * std::log(p[2])) +
                  piece.weak * std::log(p[3]));
}

}  // namespace

double likelihood_present(const PieceEvidence& piece) { return likelihood(piece, kPresent); }

double likelihood_elsewhere(const PieceEvidence& piece) {
  return kSeenBeside * likelihood(piece, kBeside) + (1 - kSeenBeside) * likelihood(piece, kNothing);
}

double likelihood_there(const PieceEvidence& piece) {
  return (1 - kWeakShare - kHiddenShare - kShadowShare) * likelihood(piece, kPresent) +
         kWeakShare * likelihood(piece, kWeak) + kHiddenShare * likelihood(piece, kNothing) +
         kShadowShare * likelihood(piece, kBeside);
}

double likelihood_partly(const PieceEvidence& piece, double elsewhere) {
  return (1 - elsewhere) * likelihood_there(piece) + elsewhere * likelihood_elsewhere(piece);
}

}  // namespace trihedron
