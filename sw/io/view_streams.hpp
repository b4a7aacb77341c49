// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/frame_stream.hpp"
#include "io/scene.hpp"
#include "io/scene_cameras.hpp"

namespace trihedron {

/// The streams of a rig's cameras in step: frame n of every view belongs together.
class ViewStreams {
 public:
  /// `cameras` is a scene_camera.json, `sources` one stream per camera in its order. Throws Error
  /// when they differ in number, or as read_cameras() and FrameStream do.
  ViewStreams(const std::filesystem::path& cameras, const std::vector<std::string>& sources);

  /// Moves every stream on by a frame; the shutters of live cameras go one right after the other,
  /// before any frame is decoded. False after the last frame. Throws Error when one stream ends
  /// and another goes on.
  bool advance();

  /// The frames as a scene, id = number of the frame from 0. Throws Error when one cannot be
  /// decoded or differs in size from its camera or from the first one.
  Scene frame();

  /// Frames in all, as far as the sources say.
  std::optional<int> count() const;

 private:
  void check_size(std::size_t view, const cv::Mat& image);

  std::vector<ViewCamera> views_;
  std::vector<std::string> sources_;
  std::deque<FrameStream> streams_;  // a deque: cv::VideoCapture is not moved
  std::vector<cv::Size> sizes_;      ///< of the first frame, 0 before it
};

}  // namespace trihedron
