// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "sim/simulator.hpp"

namespace trihedron::cli {

/// One line a frame as it leaves the pipeline, so that a sequence of any length takes no memory:
/// CSV with a header, or JSON objects where the file's name ends in .json or .jsonl.
class FrameStatistics {
 public:
  /// Writes nowhere if `file` is empty. Throws Error when it cannot be written.
  explicit FrameStatistics(const std::string& file);

  /// Throws Error when the disk refuses.
  void add(const std::string& sequence, int id, const sim::FrameResult& frame,
           std::size_t contour_pixels);

 private:
  std::string file_;
  std::ofstream out_;
  bool json_ = false;
};

}  // namespace trihedron::cli
