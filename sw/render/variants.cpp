// SPDX-License-Identifier: Apache-2.0
#include "render/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/mesh.hpp"
#include "recognition/symmetry.hpp"

namespace trihedron::render {
namespace {

using nlohmann::json;

constexpr double kStretch = 1.10;

Mesh stretched(Mesh mesh, int axis) {
  for (Eigen::Vector3d& v : mesh.vertices) v[axis] *= kStretch;
  return mesh;
}

Mesh mirrored(Mesh mesh) {
  for (Eigen::Vector3d& v : mesh.vertices) v.x() = -v.x();
  for (std::array<int, 3>& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

bool in_library(const Model& model, const std::vector<Model>& library) {
  return std::any_of(library.begin(), library.end(),
                     [&](const Model& m) { return !congruences(model, m).empty(); });
}

json matrix(const Transform& motion) {
  json out = json::array();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.push_back(motion.R(i, j));
    out.push_back(motion.t[i]);
  }
  for (double last : {0.0, 0.0, 0.0, 1.0}) out.push_back(last);
  return out;
}

json model_info(const Model& model) {
  Eigen::Vector3d low = model.mesh.vertices.at(0), high = low;
  for (const Eigen::Vector3d& v : model.mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Eigen::Vector3d size = high - low;
  json info{{"diameter", model.diameter}, {"min_x", low.x()},   {"min_y", low.y()},
            {"min_z", low.z()},           {"size_x", size.x()}, {"size_y", size.y()},
            {"size_z", size.z()}};
  for (const Transform& s : model.symmetries) info["symmetries_discrete"].push_back(matrix(s));
  return info;
}

}  // namespace

Variant variant_of(const std::string& name) {
  if (name == "none") return Variant::kNone;
  if (name == "scaled") return Variant::kScaled;
  if (name == "mirrored") return Variant::kMirrored;
  if (name == "both") return Variant::kBoth;
  throw Error("variant '" + name + "' is not known; it must be none, scaled, mirrored or both");
}

std::vector<Model> make_variants(const std::vector<Model>& library, Variant variant,
                                 Random& random) {
  if (variant == Variant::kNone) return library;
  std::vector<Model> out;
  auto add = [&](const std::string& name, const Mesh& mesh) {
    Model model = build_model(kFirstVariantId + static_cast<int>(out.size()), name, mesh);
    if (!in_library(model, library)) out.push_back(std::move(model));
  };
  for (const Model& model : library) {
    const int axis = random.below(3);
    if (variant != Variant::kMirrored)
      add(model.name + "_stretched_" + "xyz"[axis], stretched(model.mesh, axis));
    if (variant != Variant::kScaled) add(model.name + "_mirrored", mirrored(model.mesh));
  }
  return out;
}

void write_library(const std::filesystem::path& folder, const std::vector<Model>& library) {
  make_folder(folder);
  json info, names;
  for (const Model& model : library) {
    write_ply(folder / fmt::format("obj_{:06}.ply", model.id), model.mesh);
    info[std::to_string(model.id)] = model_info(model);
    names[std::to_string(model.id)] = model.name;
  }
  write_whole(folder / "models_info.json", info.dump(1));
  write_whole(folder / "models_names.json", names.dump(1));
}

}  // namespace trihedron::render
