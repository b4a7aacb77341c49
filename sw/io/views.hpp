// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "golden/front_end.hpp"
#include "io/scene.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

/// Turns 8-bit grey images, one per view, into what leaves the hardware's ports.
using FrontEnd = std::function<std::vector<ViewFeatures>(const std::vector<cv::Mat>& images)>;

/// The golden model as front end.
FrontEnd golden_front_end(const golden::FrontEndConfig& config = {});

/// The scene as recognition gets it: cameras and features, no images.
std::vector<View> make_views(const Scene& scene, const FrontEnd& front_end);

}  // namespace trihedron
