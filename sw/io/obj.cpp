// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: the lines "v x y z" and "f a b c ..."; everything else draws, or groups.
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <sstream>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/polygons.hpp"

namespace trihedron {
namespace {

struct Place {
  const std::string& file;
  int line;
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const {
    throw Error(fmt::format("{}: line {}: {}; expected {}", file, line, wrong, expected));
  }
};

Eigen::Vector3d parse_vertex(std::istringstream& words, const Place& place) {
  Eigen::Vector3d x;
  for (double& coordinate : x) {
    std::string word;
    words >> word;
    char* end = nullptr;
    coordinate = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != 0) place.fail("\"" + word + "\" is no number", "v x y z");
  }
  return x;
}

/// The vertex of a corner such as 3, 3/1, 3//2 or -1 (the last vertex so far), from 0.
int parse_corner(const std::string& word, int vertices, const Place& place) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool ends_well = end == word.data() + word.size() || *end == '/';
  const int index = number < 0 ? vertices + number : number - 1;
  if (error != std::errc() || !ends_well || number == 0 || index < 0 || index >= vertices)
    place.fail("\"" + word + "\" is no vertex so far", fmt::format("1 to {}", vertices));
  return index;
}

}  // namespace

Polygons read_obj(const std::filesystem::path& file) {
  std::istringstream in(read_whole(file, "an OBJ mesh"));
  const std::string name = file.string();
  Polygons out;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    const Place place{name, ++number};
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") out.vertices.push_back(parse_vertex(words, place));
    if (word != "f") continue;
    std::vector<int> face;
    const int vertices = static_cast<int>(out.vertices.size());
    while (words >> word) face.push_back(parse_corner(word, vertices, place));
    if (face.size() < 3) place.fail(fmt::format("{} corners", face.size()), "three or more");
    out.faces.push_back(face);
  }
  if (out.faces.empty()) throw Error(name + ": holds no face; expected lines v x y z and f a b c");
  return out;
}

}  // namespace trihedron
