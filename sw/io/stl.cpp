// SPDX-License-Identifier: Apache-2.0
// STL, binary and ASCII. Facet normals are not read: the corners' order says as much.
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/polygons.hpp"

namespace trihedron {
namespace {

constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50;  // text and count; 12 floats and 2 bytes

[[noreturn]] void fail(const std::string& name, const std::string& wrong) {
  throw Error(name + ": " + wrong + "; expected an STL mesh of triangles, binary or ASCII");
}

void add_corner(const Eigen::Vector3d& x, Polygons& out) {
  if (out.vertices.size() % 3 == 0) out.faces.emplace_back();
  out.faces.back().push_back(static_cast<int>(out.vertices.size()));
  out.vertices.push_back(x);
}

/// The size that a binary file of so many facets has, if this is one.
bool is_binary(const std::string& bytes, std::uint32_t& facets) {
  if (bytes.size() < kHeaderBytes) return false;
  std::memcpy(&facets, bytes.data() + kHeaderBytes - 4, 4);  // hosts are little-endian
  return bytes.size() == kHeaderBytes + std::uint64_t{facets} * kFacetBytes;
}

Polygons parse_binary(const std::string& bytes, std::uint32_t facets) {
  Polygons out;
  for (std::uint32_t i = 0; i < facets; ++i) {
    float corners[9];
    constexpr std::size_t kNormalBytes = 12;
    std::memcpy(corners, bytes.data() + kHeaderBytes + i * kFacetBytes + kNormalBytes,
                sizeof corners);
    for (int k = 0; k < 9; k += 3) add_corner({corners[k], corners[k + 1], corners[k + 2]}, out);
  }
  return out;
}

Polygons parse_ascii(const std::string& name, const std::string& bytes) {
  std::istringstream in(bytes);
  Polygons out;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto wrong = [&](const char* what) {
      fail(name, fmt::format("line {}: {}", number, what));
    };
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "vertex") {
      Eigen::Vector3d x;
      for (double& coordinate : x) {
        std::string text;
        words >> text;
        char* end = nullptr;
        coordinate = std::strtod(text.c_str(), &end);
        if (text.empty() || *end != 0) wrong("a vertex without three numbers");
      }
      add_corner(x, out);
    } else if (word == "endloop" && (out.faces.empty() || out.vertices.size() % 3 != 0)) {
      wrong("a loop that has not three vertices");
    }
  }
  if (out.vertices.empty() || out.vertices.size() % 3 != 0) fail(name, "the file ends too early");
  return out;
}

}  // namespace

Polygons read_stl(const std::filesystem::path& file) {
  const std::string bytes = read_whole(file, "an STL mesh"), name = file.string();
  std::uint32_t facets = 0;
  if (is_binary(bytes, facets)) return parse_binary(bytes, facets);
  if (bytes.compare(0, 5, "solid") == 0) return parse_ascii(name, bytes);
  fail(name, "neither begins with \"solid\" nor has the size that its number of facets says");
}

}  // namespace trihedron
