// SPDX-License-Identifier: Apache-2.0
#include "io/frame_stream.hpp"

#include <algorithm>
#include <charconv>
#include <opencv2/imgproc.hpp>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/image.hpp"
#include "io/quiet_decoders.hpp"

namespace trihedron {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDevice = "camera:";

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// The number in "camera:0"; nothing for other sources.
std::optional<int> device_number(const std::string& source) {
  if (!starts_with(source, kDevice)) return std::nullopt;
  const char* const first = source.data() + std::string(kDevice).size();
  const char* const last = source.data() + source.size();
  int number = -1;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last || number < 0)
    throw Error(source + ": not a camera; expected camera:0, camera:1 ... or /dev/video0");
  return number;
}

}  // namespace

bool is_image_name(const fs::path& file) {
  static const std::vector<std::string> kEndings = {".png", ".jpg",  ".jpeg", ".bmp", ".pgm",
                                                    ".ppm", ".tiff", ".tif",  ".webp"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

std::vector<fs::path> images_of(const fs::path& folder) {
  std::vector<fs::path> images;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_image_name(entry.path())) images.push_back(entry.path());
  std::sort(images.begin(), images.end());
  return images;
}

bool is_live(const std::string& source) {
  return starts_with(source, kDevice) || starts_with(source, "/dev/video") ||
         source.find("://") != std::string::npos;
}

FrameStream::FrameStream(const std::string& source) : source_(source) {
  if (fs::is_directory(source)) {
    images_ = images_of(source);
    if (images_.empty()) throw Error(source + ": no image in this folder; expected 000000.png ...");
  } else {
    if (!is_live(source))
      require_file(source, "a folder of images, an image, a video, or a camera such as camera:0");
    if (is_live(source) || !is_image_name(source))
      open_video();
    else
      images_ = {source};
  }
  if (!images_.empty()) count_ = static_cast<int>(images_.size());
}

void FrameStream::open_video() {
  const std::optional<int> device = device_number(source_);
  {
    const QuietDecoders quiet;
    if (device)
      video_.open(*device);
    else
      video_.open(source_);
  }
  if (!video_.isOpened())
    throw Error(source_ + (is_live(source_)
                               ? ": cannot be opened; expected a camera or an address that OpenCV "
                                 "reads (a free one, with the right to read it)"
                               : ": neither an image nor a video that OpenCV reads"));
  const double frames = is_live(source_) ? 0 : video_.get(cv::CAP_PROP_FRAME_COUNT);
  if (frames > 0) count_ = static_cast<int>(frames);
}

bool FrameStream::grab() {
  bool more = false;
  if (!images_.empty()) {
    more = grabbed_ < static_cast<int>(images_.size());
  } else {
    const QuietDecoders quiet;
    more = video_.grab();
  }
  if (!more && images_.empty() && count_ && grabbed_ < *count_)
    throw Error(source_ + ": the video ends after " + std::to_string(grabbed_) + " of " +
                std::to_string(*count_) + " frames");
  grabbed_ += more ? 1 : 0;
  return more;
}

cv::Mat FrameStream::retrieve() {
  if (!images_.empty()) return read_grey(images_[static_cast<std::size_t>(grabbed_ - 1)]);
  cv::Mat colour, grey;
  {
    const QuietDecoders quiet;
    video_.retrieve(colour);
  }
  if (colour.empty() || colour.depth() != CV_8U)
    throw Error(place() + ": cannot be decoded; expected 8-bit grey or colour");
  if (colour.channels() == 1) return colour;
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

std::optional<cv::Mat> FrameStream::next() {
  if (!grab()) return std::nullopt;
  return retrieve();
}

std::string FrameStream::place() const {
  if (images_.empty()) return source_ + ": frame " + std::to_string(std::max(0, grabbed_ - 1));
  return images_[static_cast<std::size_t>(std::max(0, grabbed_ - 1))].string();
}

}  // namespace trihedron
