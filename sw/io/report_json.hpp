// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "io/scene.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

/// Everything recognition says of a scene, for machines: objects, rejections, surfaces, stages.
/// Lengths mm, matrices row major, transforms world_from_model.
nlohmann::ordered_json report_json(const Scene& scene, const RecognitionResult& result,
                                   const std::vector<Model>& library);

}  // namespace trihedron
