// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/features.hpp"
#include "golden/gradient.hpp"
#include "golden/plane.hpp"

namespace trihedron::golden {

/// Registers of stage 4.
struct VertexConfig {
  /// Smallest curvature value of a vertex.
  int min_strength = 24;
};

/// Stage 4 (provisional definition). Contour pixels where the gradient direction turns, or where
/// three and more branches meet, strongest of their 5x5 window; in raster order.
std::vector<Vertex> vertices(const GradientImage& gradient,
                             const Plane<std::uint8_t>& second_contour, const VertexConfig& config);

}  // namespace trihedron::golden
