// SPDX-License-Identifier: Apache-2.0
#include "io/mesh.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
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

/// Adds a node's meshes and its children's, moved to the file's root frame.
void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, Polygons& out) {
  const aiMatrix4x4 root_from_node = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const int base = static_cast<int>(out.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D x = root_from_node * mesh.mVertices[v];
      out.vertices.emplace_back(x.x, x.y, x.z);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3) continue;  // points and lines
      std::vector<int> corners;
      for (unsigned k = 0; k < face.mNumIndices; ++k)
        corners.push_back(base + static_cast<int>(face.mIndices[k]));
      out.faces.push_back(corners);
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    collect(scene, *node.mChildren[c], root_from_node, out);
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
  if (ending_of(file) == ".off") return triangulate(name, read_off(file));
  if (ending_of(file) == ".ply") return triangulate(name, read_ply(file));
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(name, 0);  // post-processing trusts the indices
  if (scene == nullptr || scene->mRootNode == nullptr || scene->mNumMeshes == 0) {
    std::string why = importer.GetErrorString();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw Error(name + ": not a readable mesh" + (why.empty() ? "" : " (" + why + ")") +
                "; expected triangles or polygons in PLY, OBJ, STL or OFF");
  }
  Polygons polygons;
  collect(*scene, *scene->mRootNode, aiMatrix4x4(), polygons);
  return triangulate(name, polygons);
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
