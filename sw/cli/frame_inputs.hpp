// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/frame_stream.hpp"
#include "sim/stimulus.hpp"

namespace trihedron::cli {

/// An 8-bit grey OpenCV image as the simulator takes it.
sim::GreyImage to_grey_image(const cv::Mat& grey);

/// One image on its way into the front end.
struct InputFrame {
  cv::Mat grey;          ///< 8 bit
  std::string sequence;  ///< scene, folder or file it comes from: the name of its output folder
  int id = 0;            ///< number of its output files
  int view = -1;         ///< the view it belongs to; -1: any
};

/// The frames of images, folders of images, scenes (folders with gray/), folders of scenes, videos
/// and cameras (camera:0), one after the other; only one image is in memory.
class FrameInputs {
 public:
  /// With `skip_unreadable`, unreadable images and videos that end early are reported on stderr and
  /// passed over. Throws Error when an input does not exist or a folder holds no image.
  FrameInputs(const std::vector<std::string>& inputs, bool skip_unreadable);

  /// The next frame, or nothing after the last. Throws Error on an unreadable image, a video that
  /// ends early, or a frame outside the sizes that this build of the hardware takes.
  std::optional<InputFrame> next();

  /// Only the frames from number `first` to before `last`, unreadable ones counted.
  void take(std::size_t first, std::size_t last) {
    first_ = first;
    last_ = last;
  }

  /// Frames in all, as far as the files say; nothing with a live camera.
  std::optional<std::size_t> count() const {
    return endless_ ? std::nullopt : std::optional<std::size_t>(count_);
  }

 private:
  struct Item {
    std::filesystem::path path;
    std::string sequence;
    int id = 0;
    int view = -1;
    bool video = false;  ///< or a live camera
  };

  void add(const std::string& input);
  void add_video(const std::string& source);
  void add_folder(const std::filesystem::path& folder);
  void add_scenes(const std::filesystem::path& folder);
  void add_scene(const std::filesystem::path& scene);
  std::optional<InputFrame> next_image(const Item& item);
  std::optional<InputFrame> next_of_video(const Item& item);
  void end_video();

  std::deque<Item> items_;
  std::optional<FrameStream> video_;  ///< the first item, while it is read
  std::size_t count_ = 0;
  std::size_t number_ = 0;  ///< of the next frame
  std::size_t first_ = 0, last_ = std::numeric_limits<std::size_t>::max();
  bool endless_ = false, skip_unreadable_ = false;
};

}  // namespace trihedron::cli
