// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "golden/features.hpp"

namespace trihedron {

/// Writes the features of one view: FOLDER/NNNNNN.png, the contour mask (255 on the second
/// contour), and FOLDER/NNNNNN.csv, one vertex a line: x,y,branches,pattern,strength.
void write_features(const std::filesystem::path& folder, int im_id, const ViewFeatures& features);

}  // namespace trihedron
