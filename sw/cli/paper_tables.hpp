// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "recognition/paper.hpp"
#include "recognition/recognizer.hpp"

namespace trihedron::cli {

/// The source paper's Tables 1-6 of one scene: surfaces described in 3D, hypotheses, verification,
/// recognised objects, positioning error and time. Models and model surfaces by their ids and
/// indices, scene surfaces by the paper's names (s top, l side, f front, and a number).
std::string paper_tables(const std::string& scene, const PaperTrace& trace,
                         const std::vector<Model>& library);

/// recognize(); with `tables` (method paper only, else Error) it also stores paper_tables there.
RecognitionResult recognize_with_tables(const std::string& scene, const std::vector<View>& views,
                                        const Recognizer& recognizer,
                                        const RecognitionOptions& options, std::string* tables);

}  // namespace trihedron::cli
