// SPDX-License-Identifier: Apache-2.0
#include "io/image.hpp"

#include <fmt/format.h>
#include <cstdint>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "golden/error.hpp"
#include "golden/front_end.hpp"
#include "golden/plane.hpp"
#include "io/file.hpp"
#include "io/quiet_decoders.hpp"

namespace trihedron {
namespace {

/// Whether a PNG or JPEG lacks its end: the decoder would fill the rest with black or grey and say
/// nothing. In a JPEG's data behind the last start of scan (FF DA) a byte FF is never followed by
/// D9, its end, before the end.
bool is_cut(const std::string& bytes) {
  if (bytes.compare(1, 3, "PNG") == 0) return bytes.find("IEND", bytes.size() - 12) == bytes.npos;
  const std::size_t scan = bytes.rfind("\xFF\xDA");
  return bytes.compare(0, 2, "\xFF\xD8") == 0 &&
         (scan == bytes.npos || bytes.find("\xFF\xD9", scan) == bytes.npos);
}

}  // namespace

cv::Mat read_grey(const std::filesystem::path& file) {
  const std::string bytes = read_whole(file, "an image");
  const char* const expected = "; expected a whole PNG, JPEG, TIFF, BMP or PGM image";
  if (bytes.size() < 16) throw Error(file.string() + ": not an image" + expected);
  if (is_cut(bytes)) throw Error(file.string() + ": the image is cut off" + expected);
  cv::Mat grey;
  try {
    const QuietDecoders quiet;
    grey = cv::imdecode(
        cv::Mat(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data())),
        cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    grey.release();
  }
  if (grey.empty()) throw Error(file.string() + ": not a readable image" + expected);
  constexpr int kLargest = std::numeric_limits<std::int16_t>::max();
  constexpr int kSmallest = golden::kMinFrameSide;
  if (std::min(grey.cols, grey.rows) < kSmallest || std::max(grey.cols, grey.rows) > kLargest)
    throw Error(fmt::format("{}: the image is {} x {} px; expected sides of {} to {} px",
                            file.string(), grey.cols, grey.rows, kSmallest, kLargest));
  return grey;
}

void write_png(const std::filesystem::path& file, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", image, bytes)) throw Error(file.string() + ": cannot be made a PNG");
  write_whole(file, {bytes.begin(), bytes.end()});
}

}  // namespace trihedron
