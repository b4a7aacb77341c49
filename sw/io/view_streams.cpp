// SPDX-License-Identifier: Apache-2.0
#include "io/view_streams.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "golden/error.hpp"

namespace trihedron {

ViewStreams::ViewStreams(const std::filesystem::path& cameras,
                         const std::vector<std::string>& sources)
    : views_(read_cameras(cameras)), sources_(sources), sizes_(views_.size()) {
  if (sources.size() != views_.size())
    throw Error(
        fmt::format("{} holds {} views, but there are {} streams; expected one stream per "
                    "view, in the order of the file",
                    cameras.string(), views_.size(), sources.size()));
  for (const std::string& source : sources) streams_.emplace_back(source);
}

bool ViewStreams::advance() {
  std::size_t longest = streams_.size(), ended = streams_.size();
  for (std::size_t v = 0; v < streams_.size(); ++v) (streams_[v].grab() ? longest : ended) = v;
  if (ended == streams_.size()) return true;
  if (longest == streams_.size()) return false;
  throw Error(
      fmt::format("{} ends after {} frames, but {} goes on; expected streams of equal length",
                  sources_[ended], streams_[ended].grabbed(), sources_[longest]));
}

Scene ViewStreams::frame() {
  Scene scene;
  scene.id = streams_.front().grabbed() - 1;
  scene.name = fmt::format("{:06}", scene.id);
  for (std::size_t v = 0; v < views_.size(); ++v) {
    scene.images.push_back(streams_[v].retrieve());
    check_size(v, scene.images.back());
    scene.im_ids.push_back(views_[v].im_id);
    scene.cameras.push_back(views_[v].camera);
    scene.cameras.back().width_px = scene.images.back().cols;
    scene.cameras.back().height_px = scene.images.back().rows;
  }
  return scene;
}

void ViewStreams::check_size(std::size_t view, const cv::Mat& image) {
  cv::Size& first = sizes_[view];
  if (first.empty()) {
    check_image_size(views_[view].camera, views_[view].place, streams_[view].place(), image.cols,
                     image.rows);
    first = image.size();
  }
  if (image.size() == first) return;
  throw Error(fmt::format("{}: the image is {} x {} px; expected {} x {} px as in the first frame",
                          streams_[view].place(), image.cols, image.rows, first.width,
                          first.height));
}

std::optional<int> ViewStreams::count() const {
  std::optional<int> least;
  for (const FrameStream& stream : streams_)
    if (stream.count()) least = std::min(least.value_or(*stream.count()), *stream.count());
  return least;
}

}  // namespace trihedron
