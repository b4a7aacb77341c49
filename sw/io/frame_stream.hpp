// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>
#include <vector>

namespace trihedron {

/// Whether the name ends as image files do.
bool is_image_name(const std::filesystem::path& file);

/// The images of a folder, by name.
std::vector<std::filesystem::path> images_of(const std::filesystem::path& folder);

/// Whether the source is a camera device ("camera:0", "/dev/video0") or an address ("rtsp://...")
/// rather than a file or folder.
bool is_live(const std::string& source);

/// What one camera saw, frame by frame; one frame is in memory. A source is a folder of images
/// (by name), an image, a video file, an address that OpenCV opens, or a camera device.
class FrameStream {
 public:
  /// Throws Error when there is no such source, or nothing in it that OpenCV reads.
  explicit FrameStream(const std::string& source);

  /// Takes the next frame off the source, for a camera the moment of its exposure; false after the
  /// last. Throws Error when a video ends before the number of frames it announces.
  bool grab();

  /// The grabbed frame, 8 bit grey. Throws Error, with place(), when it cannot be decoded.
  cv::Mat retrieve();

  /// grab() and retrieve().
  std::optional<cv::Mat> next();

  /// The grabbed frame for messages: "top/000017.png", "top.avi: frame 17".
  std::string place() const;

  /// Frames in all, as far as the source says.
  std::optional<int> count() const { return count_; }

  /// Frames grabbed so far.
  int grabbed() const { return grabbed_; }

 private:
  void open_video();

  std::string source_;
  std::vector<std::filesystem::path> images_;  ///< empty: a video
  cv::VideoCapture video_;
  std::optional<int> count_;
  int grabbed_ = 0;
};

}  // namespace trihedron
