// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "recognition/camera.hpp"
#include "render/sensor.hpp"
#include "render/world.hpp"

namespace trihedron::render {

/// What one camera sees of a scene, with its truth.
struct RenderedView {
  cv::Mat gray;      ///< CV_8U
  cv::Mat surfaces;  ///< CV_16U, kSubsamples times as wide and high: 1 + index into the surfaces of
                     ///< the scene's objects in turn; 0: no object
  std::vector<double> visible_fraction;  ///< per object: of the samples it would cover alone; 0
                                         ///< when it lies outside the image
};

/// Renders a view. The result does not depend on `threads` (0: as many as the machine has).
/// Throws Error when the camera has no size or the scene more surfaces than 16 bits hold.
RenderedView render_view(const World& world, const Camera& camera, const Sensor& sensor,
                         std::uint64_t seed, int threads = 0);

}  // namespace trihedron::render
