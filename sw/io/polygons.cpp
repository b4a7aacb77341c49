// SPDX-License-Identifier: Apache-2.0
#include "io/polygons.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "recognition/model_surfaces.hpp"

namespace trihedron {
namespace {

/// The lines of a text that hold something, without comments.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& file)
      : name_(file.string()), in_(read_whole(file, "an OFF mesh")) {}

  /// The next line's numbers. Throws Error when it holds fewer than `least` or no numbers.
  std::vector<double> numbers(std::size_t least, const std::string& what) {
    std::vector<double> out;
    const std::string line = text(what);
    const char* at = line.c_str();
    for (char* end = nullptr;; at = end) {
      const double number = std::strtod(at, &end);
      if (end == at) break;
      out.push_back(number);
    }
    while (*at == ' ' || *at == '\t' || *at == '\r') ++at;
    if (*at != 0) fail("\"" + std::string(at) + "\" is no number", what);
    if (out.size() < least) fail(fmt::format("{} numbers", out.size()), what);
    return out;
  }

  std::string text(const std::string& what) {
    for (std::string line; std::getline(in_, line);) {
      ++line_;
      line.erase(std::min(line.find('#'), line.size()));
      const auto first = line.find_first_not_of(" \t\r");
      if (first != std::string::npos) return line.substr(first);
    }
    fail("the file ends here", what);
  }

  void put_back(const std::string& rest) {
    std::string all(std::istreambuf_iterator<char>(in_), {});
    in_ = std::istringstream(rest + "\n" + all);
    --line_;
  }

  [[noreturn]] void fail(const std::string& wrong, const std::string& what) const {
    throw Error(fmt::format("{}: line {}: {}; expected {}", name_, line_, wrong, what));
  }

 private:
  std::string name_;
  std::istringstream in_;
  int line_ = 0;
};

/// The vertex and face counts, on the header's line or the next one.
std::pair<int, int> read_counts(Lines& lines) {
  const std::string header = lines.text("the word OFF");
  const auto word_end = header.find("OFF");
  if (word_end == std::string::npos || word_end > 4) lines.fail("no OFF file", "the word OFF");
  const std::string rest = header.substr(word_end + 3);
  if (rest.find_first_not_of(" \t\r") != std::string::npos) lines.put_back(rest);
  const auto counts = lines.numbers(2, "the numbers of vertices and faces");
  constexpr double kLargest = 1e8;
  for (int i = 0; i < 2; ++i)
    if (!(counts[i] >= 0 && counts[i] < kLargest && counts[i] == std::floor(counts[i])))
      lines.fail("not a count", "the numbers of vertices and faces");
  return {static_cast<int>(counts[0]), static_cast<int>(counts[1])};
}

}  // namespace

Mesh triangulate(const std::string& name, const Polygons& polygons) {
  const int count = static_cast<int>(polygons.vertices.size());
  Mesh mesh;
  mesh.vertices = polygons.vertices;
  for (const std::vector<int>& face : polygons.faces) {
    for (int v : face)
      if (v < 0 || v >= count)
        throw Error(fmt::format("{}: a face uses vertex {}; expected 0 to {}", name, v, count - 1));
    if (face.size() == 3) {
      mesh.triangles.push_back({face[0], face[1], face[2]});
      continue;
    }
    const Eigen::Vector3d normal = area_vector2(polygons.vertices, face).normalized();
    const auto triangles = triangulate(polygons.vertices, {face}, normal);
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
  }
  return mesh;
}

Polygons read_off(const std::filesystem::path& file) {
  Lines lines(file);
  const auto [vertices, faces] = read_counts(lines);
  Polygons out;
  for (int i = 0; i < vertices; ++i) {
    const auto x = lines.numbers(3, fmt::format("x y z of vertex {}", i));
    out.vertices.emplace_back(x[0], x[1], x[2]);
  }
  for (int i = 0; i < faces; ++i) {
    const std::string what = fmt::format("the corners of face {}: count, then vertices", i);
    const auto numbers = lines.numbers(1, what);
    const double corners = numbers[0];
    if (!(corners >= 1) || corners + 1 > static_cast<double>(numbers.size()))
      lines.fail(fmt::format("{} corners, {} vertices", corners, numbers.size() - 1), what);
    std::vector<int> face;
    for (int k = 1; k <= static_cast<int>(corners); ++k) {
      const double v = numbers[static_cast<std::size_t>(k)];
      if (!(v >= 0 && v < vertices) || v != std::floor(v))
        lines.fail(fmt::format("{} is no vertex", v), fmt::format("0 to {}", vertices - 1));
      face.push_back(static_cast<int>(v));
    }
    if (face.size() >= 3) out.faces.push_back(face);
  }
  return out;
}

}  // namespace trihedron
