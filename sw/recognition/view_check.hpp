// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/recognize.hpp"

namespace trihedron {

/// Throws Error when the views cannot be crossed: fewer than two, a camera and its features that
/// differ in size, or a camera that shares no visible volume with any other.
void check_views(const std::vector<View>& views);

/// Whether some point in space is seen by both cameras (lens distortion left aside).
bool share_volume(const Camera& a, const Camera& b);

}  // namespace trihedron
