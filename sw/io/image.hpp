// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace trihedron {

/// An image file as 8-bit grey (colours weighted as OpenCV does, 16 bits cut to 8). Throws Error
/// when it is missing, broken, or smaller than the smallest legal frame.
cv::Mat read_grey(const std::filesystem::path& file);

/// Writes an image as PNG whatever the file's ending; never seen half written. Throws Error when
/// that fails.
void write_png(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace trihedron
