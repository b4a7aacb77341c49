// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/refinement.hpp"
#include "recognition/visibility.hpp"
#include "report/json_numbers.hpp"

namespace trihedron::report {

// Layers that a page draws as lines over a view's picture. All positions are px of the image as
// the camera took it, lens distortion included.

/// The vertex stream: [x, y, branches, pattern, strength] each.
Json vertex_layer(const ViewFeatures& features);

/// The closed regions: per region its boundaries, outer first, each a flat list x, y, x, y ...
Json region_layer(const ViewFeatures& features);

/// The straight segments of a view: [x0, y0, x1, y1] each.
Json segment_layer(const ViewLines& lines, const Camera& camera);

/// The visible edges of object `index` among `objects`: per piece {"crease": bool, "line": flat
/// list of px, curved where the lens bends it}.
Json edge_layer(const Camera& camera, const std::vector<PlacedModel>& objects, int index);

/// Where the image has the edges that object `index` predicts: per sample along its visible edges
/// [x, y, dx, dy], the predicted point and the way from there to the edge found in the gradient;
/// only [x, y] where the gradient shows no edge.
Json residual_layer(const FieldView& view, const std::vector<PlacedModel>& objects, int index);

}  // namespace trihedron::report
