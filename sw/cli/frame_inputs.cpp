// SPDX-License-Identifier: Apache-2.0
#include "cli/frame_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
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

bool is_image(const fs::path& file) { return fs::is_regular_file(file) && is_image_name(file); }

bool is_scene(const fs::path& folder) { return fs::is_directory(folder / "gray"); }

/// The name of a file or folder, also of "." and "a/b/".
std::string name_of(const fs::path& path) {
  const fs::path whole = fs::weakly_canonical(path);
  return fs::is_directory(whole) ? whole.filename().string() : whole.stem().string();
}

void check_size(const cv::Mat& image, const std::string& place) {
  using namespace trihedron::sim;
  if (image.cols >= kMinSizePx && image.cols <= kMaxWidthPx && image.rows >= kMinSizePx &&
      image.rows <= kMaxHeightPx) {
    return;
  }
  throw Error(fmt::format("{}: {} x {} px; this build takes {} to {} x {} to {} px", place,
                          image.cols, image.rows, kMinSizePx, kMaxWidthPx, kMinSizePx,
                          kMaxHeightPx));
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

FrameInputs::FrameInputs(const std::vector<std::string>& inputs, bool skip_unreadable)
    : skip_unreadable_(skip_unreadable) {
  for (const std::string& input : inputs) add(input);
}

void FrameInputs::add(const std::string& input) {
  if (is_live(input)) return add_video(input);
  if (!fs::exists(input)) throw Error(input + ": no such file or folder");
  if (!fs::is_directory(input)) {
    if (!is_image(input)) return add_video(input);
    items_.push_back({input, name_of(input), 0, -1, false});
    ++count_;
    return;
  }
  const std::size_t before = items_.size();
  add_scenes(input);
  if (items_.size() == before) add_folder(input);
  if (items_.size() == before)
    throw Error(input + ": no image in it; expected images, or scenes with gray/*.png");
}

void FrameInputs::add_video(const std::string& source) {
  items_.push_back({source, is_live(source) ? "live" : name_of(source), 0, -1, true});
  if (is_live(source)) {
    endless_ = true;
    return;
  }
  count_ += FrameStream(source).count().value_or(0);
}

void FrameInputs::add_folder(const fs::path& folder) {
  int id = 0;
  for (const fs::path& file : images_of(folder))
    items_.push_back({file, name_of(folder), id++, -1, false});
  count_ += static_cast<std::size_t>(id);
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
  while (!items_.empty() && number_ < last_) {
    const Item item = items_.front();
    try {
      std::optional<InputFrame> frame = item.video ? next_of_video(item) : next_image(item);
      if (frame) return frame;
    } catch (const Error& error) {
      if (!skip_unreadable_)
        throw Error(std::string(error.what()) + "; --skip-unreadable passes over it");
      std::fprintf(stderr, "trihedron: %s; passed over\n", error.what());
      if (item.video) end_video();
    }
  }
  return std::nullopt;
}

std::optional<InputFrame> FrameInputs::next_image(const Item& item) {
  items_.pop_front();
  if (number_++ < first_) return std::nullopt;
  cv::Mat image = read_grey(item.path);
  check_size(image, item.path.string());
  return InputFrame{std::move(image), item.sequence, item.id, item.view};
}

std::optional<InputFrame> FrameInputs::next_of_video(const Item& item) {
  if (!video_) video_.emplace(item.path.string());
  if (!video_->grab()) {
    end_video();
    return std::nullopt;
  }
  if (number_++ < first_) return std::nullopt;
  cv::Mat image = video_->retrieve();
  check_size(image, video_->place());
  return InputFrame{std::move(image), item.sequence, video_->grabbed() - 1, item.view};
}

void FrameInputs::end_video() {
  video_.reset();
  items_.pop_front();
}

}  // namespace trihedron::cli
