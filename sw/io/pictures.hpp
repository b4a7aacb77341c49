// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "io/scene.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

/// A picture of one stage of one view, 8-bit colour.
struct Picture {
  std::string stage;  ///< gradient, first_contour, second_contour, vertices, regions, models
  cv::Mat image;
};

/// What the hardware put out for one view, stage by stage, and the closed regions in it. `grey`
/// lies under vertices and regions.
std::vector<Picture> feature_pictures(const cv::Mat& grey, const ViewFeatures& features);

/// The recognised models over the image, hidden lines removed, a colour and a name each.
Picture model_picture(const cv::Mat& grey, const Camera& camera, const RecognitionResult& result,
                      const std::vector<Model>& library);

/// Writes FOLDER/VIEW_STAGE.png for every view and stage, and FOLDER/overview.png: a row per
/// view, a column per stage.
void write_pictures(const std::filesystem::path& folder, const Scene& scene,
                    const std::vector<View>& views, const RecognitionResult& result,
                    const std::vector<Model>& library);

}  // namespace trihedron
