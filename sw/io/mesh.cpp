// SPDX-License-Identifier: Apache-2.0
#include "io/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/polygons.hpp"

namespace trihedron {
namespace {

/// The file name's ending in lower case, dot included.
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  return ending == ".ply" || ending == ".obj" || ending == ".stl" || ending == ".off";
}

Mesh read_mesh(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (!is_mesh_name(file))
    throw Error(name + ": not a mesh that can be read; expected a .ply, .obj, .stl or .off file");
  require_file(file, "a mesh");
  const std::string ending = ending_of(file);
  return triangulate(name, ending == ".off"   ? read_off(file)
                           : ending == ".ply" ? read_ply(file)
                           : ending == ".stl" ? read_stl(file)
                                              : read_obj(file));
}

void write_ply(const std::filesystem::path& file, const Mesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\ncomment units: mm\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.triangles.size());
  for (const auto& x : mesh.vertices) text += fmt::format("{} {} {}\n", x.x(), x.y(), x.z());
  for (const auto& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  write_whole(file, text);
}

}  // namespace trihedron
