// SPDX-License-Identifier: Apache-2.0
#include "cli/frame_inputs.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "golden/error.hpp"
#include "io/image.hpp"
#include "sim/stimulus.hpp"

namespace trihedron::cli {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_image(const fs::path& file) {
  static const std::vector<std::string> kEndings = {".png", ".jpg",  ".jpeg", ".bmp", ".pgm",
                                                    ".ppm", ".tiff", ".tif",  ".webp"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return fs::is_regular_file(file) &&
         std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

bool is_scene(const fs::path& folder) { return fs::is_directory(folder / "gray"); }

/// The name of a file or folder, also of "." and "a/b/".
std::string name_of(const fs::path& path) {
  const fs::path whole = fs::weakly_canonical(path);
  return fs::is_directory(whole) ? whole.filename().string() : whole.stem().string();
}

void check_size(const cv::Mat& image, const fs::path& file) {
  using namespace trihedron::sim;
  if (image.cols >= kMinSizePx && image.cols <= kMaxWidthPx && image.rows >= kMinSizePx &&
      image.rows <= kMaxHeightPx) {
    return;
  }
  throw Error(file.string() + ": " + std::to_string(image.cols) + " x " +
              std::to_string(image.rows) + " px; this build takes " + std::to_string(kMinSizePx) +
              " to " + std::to_string(kMaxWidthPx) + " x " + std::to_string(kMinSizePx) + " to " +
              std::to_string(kMaxHeightPx) + " px");
}

}  // namespace

sim::GreyImage to_grey_image(const cv::Mat& grey) {
  sim::GreyImage image{grey.cols, grey.rows, {}};
  image.pixels.reserve(grey.total());
  for (int y = 0; y < grey.rows; ++y) {
    const std::uint8_t* row = grey.ptr(y);
    image.pixels.insert(image.pixels.end(), row, row + grey.cols);
  }
  return image;
}

FrameInputs::FrameInputs(const std::vector<std::string>& inputs, bool keep_going)
    : keep_going_(keep_going) {
  for (const std::string& input : inputs) add(input);
}

void FrameInputs::add(const fs::path& input) {
  if (!fs::exists(input)) throw Error(input.string() + ": no such file or folder");
  if (!fs::is_directory(input)) return add_file(input);
  const std::size_t before = items_.size();
  add_scenes(input);
  if (items_.size() == before) add_folder(input);
  if (items_.size() == before) {
    throw Error(input.string() + ": no image in it; expected images, or scenes with gray/*.png");
  }
}

void FrameInputs::add_file(const fs::path& file) {
  const bool video = !is_image(file);
  items_.push_back({file, name_of(file), 0, -1, video});
  if (!video) {
    ++count_;
    return;
  }
  cv::VideoCapture probe(file.string());
  if (!probe.isOpened())
    throw Error(file.string() + ": neither an image nor a video that OpenCV reads");
  count_ += std::max(0, static_cast<int>(probe.get(cv::CAP_PROP_FRAME_COUNT)));
}

void FrameInputs::add_folder(const fs::path& folder) {
  int id = 0;
  for (const fs::path& file : sorted_entries(folder)) {
    if (is_image(file)) items_.push_back({file, name_of(folder), id++, -1, false});
  }
  count_ += id;
}

void FrameInputs::add_scenes(const fs::path& folder) {
  if (is_scene(folder)) return add_scene(folder);
  for (const fs::path& entry : sorted_entries(folder)) {
    if (fs::is_directory(entry)) add_scenes(entry);
  }
}

void FrameInputs::add_scene(const fs::path& scene) {
  for (const fs::path& file : sorted_entries(scene / "gray")) {
    if (!is_image(file)) continue;
    const std::string stem = file.stem().string();
    int id = 0;
    if (std::from_chars(stem.data(), stem.data() + stem.size(), id).ec != std::errc()) continue;
    items_.push_back({file, name_of(scene), id, id < sim::kViews ? id : -1, false});
    ++count_;
  }
}

std::optional<InputFrame> FrameInputs::next() {
  while (!items_.empty()) {
    const Item item = items_.front();
    if (!item.video) items_.pop_front();
    try {
      std::optional<cv::Mat> image = item.video ? next_of_video() : read_grey(item.path);
      if (!image) continue;  // the video is over
      check_size(*image, item.path);
      return InputFrame{std::move(*image), item.sequence, item.video ? video_frames_ - 1 : item.id,
                        item.view};
    } catch (const Error& error) {
      if (!keep_going_) throw;
      std::fprintf(stderr, "trihedron: %s; passed over\n", error.what());
      if (item.video && !items_.empty() && items_.front().path == item.path) items_.pop_front();
    }
  }
  return std::nullopt;
}

std::optional<cv::Mat> FrameInputs::next_of_video() {
  const fs::path path = items_.front().path;
  if (!video_.isOpened()) {
    video_frames_ = 0;
    if (!video_.open(path.string())) throw Error(path.string() + ": not a video that OpenCV reads");
  }
  cv::Mat colour;
  if (video_.read(colour) && !colour.empty()) {
    ++video_frames_;
    cv::Mat grey;
    if (colour.channels() == 1)
      grey = colour;
    else
      cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
    return grey;
  }
  const int announced = static_cast<int>(video_.get(cv::CAP_PROP_FRAME_COUNT));
  video_.release();
  items_.pop_front();
  if (video_frames_ >= announced) return std::nullopt;
  throw Error(path.string() + ": the video ends after " + std::to_string(video_frames_) + " of " +
              std::to_string(announced) + " frames");
}

}  // namespace trihedron::cli
