// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "recognition/displaced_surface.hpp"
#include "recognition/object_evidence.hpp"
#include "recognition/spread_map.hpp"

namespace trihedron {

/// The judgement on one object of a scene.
struct Verdict {
  /// Expected number of poses among `tests` random ones that would find as much: the number of
  /// false alarms, as log10.
  double log10_false_alarms = 0;
  /// Log likelihood ratio of the evidence, object against chance: ranks explanations.
  double log_against_chance = 0;
  /// Log odds "there" against "a view that should show the object does not", worst view.
  double log_against_unseen = 0;
  DisplacedSurface displaced;
  double log_odds = 0;     ///< right against wrong, all of the above weighed together
  double found_share = 0;  ///< of the visible edge length
  double visible_px = 0;   ///< edge length asked for
  bool accepted = false;
  /// Not accepted, but worth being held against all that is alike.
  bool doubtful = false;
  std::string reason;  ///< one line, why not; empty when accepted
};

/// What a piece of evidence can say against chance.
struct PieceOdds {
  double answers = 0;        ///< independent ones
  double hit = 0, miss = 0;  ///< log likelihood ratio of an answer
  double chance = 0;         ///< probability of a hit by chance
};
PieceOdds piece_odds(const std::vector<SpreadMap>& chance, const PieceEvidence& piece);

/// Log likelihood ratio of the evidence, object against chance.
double log_against_chance(const std::vector<SpreadMap>& chance, const ObjectEvidence& evidence);

/// Least log evidence of a doubtful object.
inline constexpr double kDoubtfulEvidence = 40;

struct VerificationOptions {
  double tests = 1e4;  ///< poses that were in question
};

/// Judges `objects[index]` by its evidence; `chance` is each view's map of all contours. The
/// object must be unlikely as an accident, and right rather than wrong by the odds of all that
/// speaks for and against it.
Verdict verify(const std::vector<FieldView>& views, const std::vector<SpreadMap>& chance,
               const std::vector<PlacedModel>& objects, int index, const ObjectEvidence& evidence,
               const VerificationOptions& options = {});

}  // namespace trihedron
