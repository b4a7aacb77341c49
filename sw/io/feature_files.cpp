// SPDX-License-Identifier: Apache-2.0
#include "io/feature_files.hpp"

#include <fmt/format.h>

#include "io/file.hpp"
#include "io/image.hpp"

namespace trihedron {

void write_features(const std::filesystem::path& folder, int im_id, const ViewFeatures& features) {
  cv::Mat mask(features.height, features.width, CV_8U);
  for (int y = 0; y < features.height; ++y)
    for (int x = 0; x < features.width; ++x)
      mask.at<unsigned char>(y, x) = features.at(x, y).contour() ? 255 : 0;
  std::string vertices = "x,y,branches,pattern,strength\n";
  for (const Vertex& v : features.vertices)
    vertices += fmt::format("{},{},{},{},{}\n", v.x, v.y, v.branches, v.pattern, v.strength);
  make_folder(folder);
  write_png(folder / fmt::format("{:06d}.png", im_id), mask);
  write_whole(folder / fmt::format("{:06d}.csv", im_id), vertices);
}

}  // namespace trihedron
