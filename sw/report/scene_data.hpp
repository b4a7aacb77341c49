// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/scene.hpp"
#include "recognition/recognize.hpp"
#include "report/hardware_activity.hpp"
#include "report/json_numbers.hpp"

namespace trihedron::report {

/// A scene and all that became of it; what it refers to outlives it.
struct RecognizedScene {
  const Scene& scene;
  const std::vector<View>& views;
  const std::vector<Model>& library;
  const RecognitionResult& result;
  std::string front_end;      ///< "rtl" or "golden"
  std::string method;         ///< "full" or "paper"
  HardwareActivity hardware;  ///< no views: the front end was not simulated
};

/// Whether the scene came out other than its truth says: an object of the library not found, or a
/// result that matches none. Without truth: whether nothing was found.
bool failed(const RecognizedScene& input);

/// One line of an overview: name, kind, what was found, how that compares with the truth, time of
/// the software, and a small picture of the first view with the models drawn in.
Json scene_line(const RecognizedScene& input);

/// Everything that the page shows of a scene: io/report_json's document with the layers of each
/// view, where rejected hypotheses would have stood, the scene in space and the hardware's counters
/// added.
Json scene_data(const RecognizedScene& input);

}  // namespace trihedron::report
