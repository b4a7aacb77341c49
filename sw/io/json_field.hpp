// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace trihedron {

/// A value inside a JSON file that knows its place: every accessor throws Error with file, field
/// and what was expected. The document must outlive it.
class JsonField {
 public:
  JsonField(const nlohmann::json& value, std::string file)
      : value_(&value), file_(std::move(file)) {}

  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  JsonField operator[](const std::string& key) const;
  std::vector<JsonField> items() const;
  std::vector<std::string> keys() const;

  double number() const;  ///< finite
  int integer() const;
  std::string text() const;
  std::vector<double> numbers(std::size_t count) const;  ///< a list of `count` finite numbers

  /// "scene_camera.json: 0.cam_K", for messages.
  std::string place() const { return field_.empty() ? file_ : file_ + ": " + field_; }

  /// Throws Error: place(), `what` ("expected ...").
  [[noreturn]] void fail(const std::string& what) const;

 private:
  JsonField(const nlohmann::json& value, std::string file, std::string field)
      : value_(&value), file_(std::move(file)), field_(std::move(field)) {}

  const nlohmann::json* value_;
  std::string file_, field_;
};

/// The document of a JSON file. Throws Error with line and column when it is broken.
nlohmann::json read_json(const std::filesystem::path& file);

}  // namespace trihedron
