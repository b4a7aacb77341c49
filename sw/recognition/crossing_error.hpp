// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "recognition/model.hpp"
#include "recognition/planar_view.hpp"

namespace trihedron {

/// The paper's Error, mm. Corners of one point in two views differ by at most half a pixel each;
/// but more than half the smallest distance of two edges would confuse corners.
double crossing_error_mm(const std::array<PlanarView, 3>& views, const std::vector<Model>& library);

/// Smallest distance between two edges of the model that share no vertex, mm.
double smallest_edge_gap_mm(const Model& model);

}  // namespace trihedron
