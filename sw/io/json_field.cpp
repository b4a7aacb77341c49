// SPDX-License-Identifier: Apache-2.0
#include "io/json_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/error.hpp"
#include "io/file.hpp"

namespace trihedron {

using nlohmann::json;

void JsonField::fail(const std::string& what) const { throw Error(place() + ": " + what); }

JsonField JsonField::operator[](const std::string& key) const {
  const std::string path = field_.empty() ? key : field_ + "." + key;
  if (!value_->is_object()) fail(fmt::format("expected an object with \"{}\"", key));
  const auto found = value_->find(key);
  if (found == value_->end()) throw Error(file_ + ": " + path + " is missing");
  return {*found, file_, path};
}

std::vector<JsonField> JsonField::items() const {
  if (!value_->is_array()) fail("expected a list");
  std::vector<JsonField> out;
  for (std::size_t i = 0; i < value_->size(); ++i)
    out.push_back({(*value_)[i], file_, fmt::format("{}[{}]", field_, i)});
  return out;
}

std::vector<std::string> JsonField::keys() const {
  if (!value_->is_object()) fail("expected an object");
  std::vector<std::string> out;
  for (const auto& item : value_->items()) out.push_back(item.key());
  return out;
}

double JsonField::number() const {
  if (!value_->is_number()) fail(std::string("expected a number, found ") + value_->type_name());
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("expected a finite number");
  return number;
}

int JsonField::integer() const {
  const double value = number();
  constexpr double kLimit = std::numeric_limits<int>::max();
  if (value != std::floor(value) || std::abs(value) > kLimit) fail("expected an integer");
  return static_cast<int>(value);
}

std::string JsonField::text() const {
  if (!value_->is_string()) fail(std::string("expected a text, found ") + value_->type_name());
  return value_->get<std::string>();
}

std::vector<double> JsonField::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count)
    fail(fmt::format("expected a list of {} numbers", count));
  std::vector<double> out;
  for (const JsonField& item : items()) out.push_back(item.number());
  return out;
}

json read_json(const std::filesystem::path& file) {
  const std::string bytes = read_whole(file, "a JSON file");
  try {
    return json::parse(bytes);
  } catch (const json::exception& error) {
    std::string why = error.what();
    const auto start = why.find("] ");
    if (start != std::string::npos) why = why.substr(start + 2);
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw Error(file.string() + ": broken JSON: " + why);
  }
}

}  // namespace trihedron
