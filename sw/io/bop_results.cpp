// SPDX-License-Identifier: Apache-2.0
#include "io/bop_results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "golden/error.hpp"
#include "io/file.hpp"

namespace trihedron {
namespace {

constexpr const char* kHeader = "scene_id,im_id,obj_id,score,R,t,time";

std::string place(const std::string& file, int line, const char* field) {
  return fmt::format("{}: line {}: {}: ", file, line, field);
}

/// `count` finite numbers separated by blanks.
std::vector<double> parse_numbers(const std::string& text, std::size_t count,
                                  const std::string& where) {
  std::vector<double> out;
  const char* at = text.c_str();
  for (;;) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at) break;
    if (!std::isfinite(number)) throw Error(where + "expected finite numbers");
    out.push_back(number);
    at = end;
  }
  if (out.size() != count || std::string(at).find_first_not_of(" \r") != std::string::npos)
    throw Error(fmt::format("{}expected {} number{}", where, count, count == 1 ? "" : "s"));
  return out;
}

ResultRow parse_row(const std::vector<std::string>& fields, const std::string& file, int line) {
  const auto number = [&](int i, const char* name) {
    return parse_numbers(fields[i], 1, place(file, line, name))[0];
  };
  const auto integer = [&](int i, const char* name) {
    const double value = number(i, name);
    constexpr double kLargest = std::numeric_limits<int>::max();
    if (value != std::floor(value) || value < 0 || value > kLargest)
      throw Error(place(file, line, name) + "expected an integer from 0");
    return static_cast<int>(value);
  };
  ResultRow row;
  row.scene_id = integer(0, "scene_id");
  row.im_id = integer(1, "im_id");
  row.model_id = integer(2, "obj_id");
  row.score = number(3, "score");
  const auto R = parse_numbers(fields[4], 9, place(file, line, "R"));
  const auto t = parse_numbers(fields[5], 3, place(file, line, "t"));
  for (int i = 0; i < 9; ++i) row.camera_from_model.R(i / 3, i % 3) = R[i];
  row.camera_from_model.t = {t[0], t[1], t[2]};
  row.seconds = number(6, "time");
  return row;
}

}  // namespace

std::vector<ResultRow> result_rows(const Scene& scene, const RecognitionResult& result,
                                   double seconds) {
  std::vector<ResultRow> rows;
  for (const RecognizedObject& object : result.objects)
    rows.push_back({scene.id, scene.im_ids[0], object.model_id, object.score,
                    scene.cameras[0].camera_from_world * object.world_from_model, seconds});
  return rows;
}

std::string format_results(const std::vector<ResultRow>& rows) {
  std::string out = std::string(kHeader) + "\n";
  for (const ResultRow& row : rows) {
    const auto& R = row.camera_from_model.R;
    const auto& t = row.camera_from_model.t;
    out += fmt::format("{},{},{},{:.6f},", row.scene_id, row.im_id, row.model_id, row.score);
    for (int i = 0; i < 9; ++i) out += fmt::format("{}{:.9f}", i == 0 ? "" : " ", R(i / 3, i % 3));
    out += fmt::format(",{:.6f} {:.6f} {:.6f},{:.6f}\n", t.x(), t.y(), t.z(), row.seconds);
  }
  return out;
}

std::vector<ResultRow> read_results(const std::filesystem::path& file) {
  std::istringstream in(read_whole(file, "a BOP results CSV"));
  std::string text;
  std::getline(in, text);
  if (!text.empty() && text.back() == '\r') text.pop_back();
  if (text != kHeader) throw Error(place(file.string(), 1, "header") + "expected " + kHeader);
  std::vector<ResultRow> rows;
  for (int line = 2; std::getline(in, text); ++line) {
    if (text.empty()) continue;
    std::vector<std::string> fields;
    std::istringstream split(text);
    for (std::string field; std::getline(split, field, ',');) fields.push_back(field);
    if (fields.size() != 7)
      throw Error(fmt::format("{}: line {}: {} fields; expected 7: {}", file.string(), line,
                              fields.size(), kHeader));
    rows.push_back(parse_row(fields, file.string(), line));
  }
  return rows;
}

}  // namespace trihedron
