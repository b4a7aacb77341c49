// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "recognition/paper_identification.hpp"
#include "recognition/recognize.hpp"
#include "recognition/surfaces.hpp"

namespace trihedron {

/// The paper's Tables 1-6 of one scene.
struct PaperTrace {
  double error_mm = 0;                   ///< the Error of eqs. 5-8
  std::array<int, 3> regions{};          ///< closed regions of top, side, front
  int incomplete = 0;                    ///< regions with a corner without a partner
  int not_planar = 0;                    ///< regions whose corners found false partners
  int in_pieces = 0;                     ///< regions that an unfinished contour divides
  int contradicted = 0;                  ///< surfaces that another view's corners contradict
  int duplicates = 0;                    ///< described ones that a higher view holds too
  std::vector<CrossedSurface> surfaces;  ///< Table 1
  std::vector<std::vector<PaperHypothesis>> hypotheses;  ///< Table 2, per surface
  std::vector<PaperIdentification> priority_list;        ///< Tables 3-6, in order of priority
  double seconds = 0;  ///< identification and positioning (Table 6)
};

/// The paper's name of a surface: s (top), l (side) or f (front) and the number of its region,
/// from 1.
std::string paper_name(const CrossedSurface& surface);

/// The source method, docs/paper.md: regions, data crossing, hypotheses, surface-pair sequences,
/// priority list, two-step positioning. Uses one top, one side and one front view; perspective
/// views as scaled orthographic ones. Throws Error when one of the three is missing. `trace`, when
/// given, receives the paper's tables.
RecognitionResult recognize_paper(const std::vector<View>& views, const std::vector<Model>& library,
                                  const RecognitionOptions& options = {},
                                  PaperTrace* trace = nullptr);

}  // namespace trihedron
