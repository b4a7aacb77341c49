// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/features.hpp"

namespace trihedron {

/// The contour pixels of a view (1, raster order), weak edges included (see weak_ridges.hpp), with
/// gaps closed. Every loose end is joined straight on to a contour over at most `bridge_px`
/// missing pixels, or else continued along the ridge of the gradient's magnitude until it meets a
/// contour (then its path becomes contour) or the ridge ends (then nothing changes).
std::vector<std::uint8_t> linked_contour(const ViewFeatures& features, int bridge_px);

}  // namespace trihedron
