// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/scene.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

/// A line of a BOP results file.
struct ResultRow {
  int scene_id = 0;
  int im_id = 0;
  int model_id = 0;
  double score = 0;
  Transform camera_from_model;  ///< camera of im_id
  double seconds = -1;          ///< recognition of the whole scene, -1: unknown
};

/// The rows of a recognised scene, poses in the camera frame of the scene's first view.
std::vector<ResultRow> result_rows(const Scene& scene, const RecognitionResult& result,
                                   double seconds);

/// The file's bytes: header scene_id,im_id,obj_id,score,R,t,time, then one row a line.
std::string format_results(const std::vector<ResultRow>& rows);

/// Reads a BOP results file. Throws Error with file, line and field.
std::vector<ResultRow> read_results(const std::filesystem::path& file);

}  // namespace trihedron
