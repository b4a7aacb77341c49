// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "calibration/start_values.hpp"

namespace trihedron {

/// Lenses, camera poses and board poses together, so that the sum of squared distances between
/// found and projected corners is least; the first camera stays where it is. Changes `rig`. Returns
/// the standard deviations; throws Error when the images leave something undetermined.
std::vector<CameraUncertainty> adjust(RigEstimate& rig, const std::vector<CameraShots>& cameras,
                                      const Board& board, const CalibrateOptions& options);

}  // namespace trihedron
