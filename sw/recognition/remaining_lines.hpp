// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {

/// The lines of a view without the segments that the visible edges of `known` objects explain;
/// corners and stops as if those were not there.
ViewLines remaining_lines(const ViewLines& lines, const Camera& camera,
                          const std::vector<PlacedModel>& known);

}  // namespace trihedron
