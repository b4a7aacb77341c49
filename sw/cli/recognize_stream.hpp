// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/recognition_options.hpp"

namespace trihedron::cli {

/// The options of `recognize --stream`.
struct StreamArguments {
  std::vector<std::string> sources;  ///< one per view
  std::string cameras;               ///< scene_camera.json
  int limit = 0;                     ///< frames, 0: all
  bool skip_unreadable = false;

  void add_to(CLI::App& command);
};

/// Recognises frame after frame and writes a line of JSON for each: to standard output unless
/// `quiet`, and to OUT/results.jsonl unless `out` is empty. Memory does not grow with the number
/// of frames. Ctrl-C ends it after the frame in work; the file then holds what was done.
/// Returns the exit code. Throws Error on a bad frame (unless skip_unreadable), after writing the
/// file.
int recognize_stream(const StreamArguments& arguments, const RecognitionArguments& recognition,
                     const std::string& out, bool quiet);

}  // namespace trihedron::cli
