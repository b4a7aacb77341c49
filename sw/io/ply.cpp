// SPDX-License-Identifier: Apache-2.0
// PLY, ASCII and binary of both byte orders. Elements other than vertex and face are skipped.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/polygons.hpp"

namespace trihedron {
namespace {

enum class Format { kAscii, kLittleEndian, kBigEndian };

struct Type {
  std::size_t bytes = 0;
  bool real = false, is_signed = false;
};

struct Property {
  std::string name;
  bool list = false;
  Type count, value;
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::kAscii;
  std::vector<Element> elements;
  std::size_t bytes = 0;
};

[[noreturn]] void fail(const std::string& name, const std::string& wrong) {
  throw Error(name + ": " + wrong + "; expected a PLY mesh of vertices x y z and faces");
}

Type parse_type(const std::string& name, const std::string& word) {
  if (word == "char" || word == "int8") return {1, false, true};
  if (word == "uchar" || word == "uint8") return {1, false, false};
  if (word == "short" || word == "int16") return {2, false, true};
  if (word == "ushort" || word == "uint16") return {2, false, false};
  if (word == "int" || word == "int32") return {4, false, true};
  if (word == "uint" || word == "uint32") return {4, false, false};
  if (word == "float" || word == "float32") return {4, true, true};
  if (word == "double" || word == "float64") return {8, true, true};
  fail(name, "header: unknown type \"" + word + "\"");
}

Format parse_format(const std::string& name, const std::string& word) {
  if (word == "ascii") return Format::kAscii;
  if (word == "binary_little_endian") return Format::kLittleEndian;
  if (word == "binary_big_endian") return Format::kBigEndian;
  fail(name, "header: unknown format \"" + word + "\"");
}

Property parse_property(const std::string& name, std::istringstream& words) {
  Property property;
  std::string type;
  words >> type;
  if (type == "list") {
    property.list = true;
    words >> type;
    property.count = parse_type(name, type);
    words >> type;
  }
  property.value = parse_type(name, type);
  words >> property.name;
  return property;
}

Header parse_header(const std::string& name, const std::string& bytes) {
  Header header;
  std::size_t at = 0;
  for (bool first = true;; first = false) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) fail(name, "the header has no end_header");
    std::istringstream words(bytes.substr(at, end - at));
    at = end + 1;
    std::string word;
    words >> word;
    if (first && word != "ply") fail(name, "does not begin with \"ply\"");
    if (word == "end_header") break;
    if (word == "format") {
      words >> word;
      header.format = parse_format(name, word);
    } else if (word == "element") {
      Element element;
      words >> element.name >> element.count;
      if (!words || element.count < 0) fail(name, "header: an element without a count");
      header.elements.push_back(element);
    } else if (word == "property") {
      if (header.elements.empty()) fail(name, "header: a property before its element");
      header.elements.back().properties.push_back(parse_property(name, words));
    } else if (!first && word != "comment" && word != "obj_info") {
      fail(name, "header: unknown line \"" + word.substr(0, 20) + "\"");
    }
  }
  header.bytes = at;
  return header;
}

/// The numbers after the header, one after the other.
class Numbers {
 public:
  Numbers(const std::string& name, const std::string& bytes, const Header& header)
      : name_(name),
        at_(bytes.c_str() + header.bytes),
        end_(bytes.c_str() + bytes.size()),
        format_(header.format) {}

  double next(const Type& type) {
    return format_ == Format::kAscii ? next_ascii() : next_binary(type);
  }

 private:
  double next_ascii() {
    char* after = nullptr;
    const double number = std::strtod(at_, &after);  // the text ends in a zero byte
    if (after == at_) fail(name_, at_ >= end_ ? "the file ends too early" : "a word is no number");
    at_ = after;
    return number;
  }

  double next_binary(const Type& type) {
    if (static_cast<std::size_t>(end_ - at_) < type.bytes) fail(name_, "the file ends too early");
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), at_, type.bytes);
    at_ += type.bytes;
    if (format_ == Format::kBigEndian) std::reverse(raw.begin(), raw.begin() + type.bytes);
    if (type.real) return type.bytes == 4 ? as<float>(raw) : as<double>(raw);
    if (type.bytes == 1) return type.is_signed ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
    if (type.bytes == 2) return type.is_signed ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
    return type.is_signed ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
  }

  template <typename Value>
  static double as(const std::array<char, 8>& raw) {
    Value value;  // hosts are little-endian
    std::memcpy(&value, raw.data(), sizeof value);
    return static_cast<double>(value);
  }

  const std::string& name_;
  const char *at_, *end_;
  Format format_;
};

std::vector<double> read_list(const std::string& name, Numbers& numbers, const Property& property) {
  const double count = property.list ? numbers.next(property.count) : 1;
  if (!(count >= 0 && count < 1e6)) fail(name, fmt::format("a list of {} numbers", count));
  std::vector<double> out;
  for (int i = 0; i < static_cast<int>(count); ++i) out.push_back(numbers.next(property.value));
  return out;
}

void read_vertex(const std::string& name, Numbers& numbers, const Element& element, Polygons& out) {
  Eigen::Vector3d x = Eigen::Vector3d::Constant(std::nan(""));
  for (const Property& property : element.properties) {
    const std::vector<double> values = read_list(name, numbers, property);
    if (property.list || property.name.size() != 1) continue;
    const char axis = property.name[0];
    if (axis >= 'x' && axis <= 'z') x[axis - 'x'] = values[0];
  }
  out.vertices.push_back(x);
}

void read_face(const std::string& name, Numbers& numbers, const Element& element, Polygons& out) {
  for (const Property& property : element.properties) {
    const std::vector<double> values = read_list(name, numbers, property);
    if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
    std::vector<int> face;
    for (double v : values) {
      if (!(v >= 0 && v < 1e9) || v != std::floor(v)) fail(name, fmt::format("{} is no vertex", v));
      face.push_back(static_cast<int>(v));
    }
    if (face.size() >= 3) out.faces.push_back(face);
  }
}

}  // namespace

Polygons read_ply(const std::filesystem::path& file) {
  const std::string bytes = read_whole(file, "a PLY mesh"), name = file.string();
  const Header header = parse_header(name, bytes);
  Numbers numbers(name, bytes, header);
  Polygons out;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    for (long i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_vertex(name, numbers, element, out);
      else if (element.name == "face")
        read_face(name, numbers, element, out);
      else
        for (const Property& property : element.properties) read_list(name, numbers, property);
    }
  }
  return out;
}

}  // namespace trihedron
