// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace trihedron::report {

/// The image as PNG inside a "data:" address, which a page can show without any other file.
std::string png_data_uri(const cv::Mat& image);

/// Bytes in the 64 printable characters of RFC 4648, padded with '='.
std::string base64(const std::vector<unsigned char>& bytes);

}  // namespace trihedron::report
