// SPDX-License-Identifier: Apache-2.0
#include "io/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/json_field.hpp"
#include "io/mesh.hpp"
#include "recognition/symmetry.hpp"

namespace trihedron {
namespace {

namespace fs = std::filesystem;

/// The id in a name like obj_000007, 0 when the name has none.
int id_in_name(const std::string& stem) {
  constexpr const char kPrefix[] = "obj_";
  int id = 0;
  if (stem.rfind(kPrefix, 0) != 0) return 0;
  const char* const first = stem.data() + sizeof kPrefix - 1;
  const char* const last = stem.data() + stem.size();
  const auto [end, error] = std::from_chars(first, last, id);
  return error == std::errc() && end == last && id > 0 ? id : 0;
}

std::map<int, fs::path> mesh_files(const fs::path& folder) {
  require_folder(folder, "a folder of meshes (obj_000001.ply ...)");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_mesh_name(entry.path())) files.push_back(entry.path());
  if (files.empty())
    throw Error(folder.string() +
                ": no meshes in this folder; expected .ply, .obj, .stl or .off files");
  std::sort(files.begin(), files.end());
  std::map<int, fs::path> by_id;
  for (const fs::path& file : files) {
    const int id = id_in_name(file.stem().string());
    if (id == 0) continue;
    const auto [at, fresh] = by_id.emplace(id, file);
    if (!fresh)
      throw Error(fmt::format("{}: model {} is also {}; expected one file for each model",
                              file.string(), id, at->second.filename().string()));
  }
  int next = by_id.empty() ? 1 : by_id.rbegin()->first + 1;
  for (const fs::path& file : files)
    if (id_in_name(file.stem().string()) == 0) by_id.emplace(next++, file);
  return by_id;
}

std::map<int, std::string> read_names(const fs::path& folder) {
  std::map<int, std::string> names;
  const fs::path file = folder / "models_names.json";
  if (!fs::exists(file)) return names;
  const nlohmann::json document = read_json(file);
  const JsonField root(document, file.string());
  for (const std::string& key : root.keys()) names[std::atoi(key.c_str())] = root[key].text();
  return names;
}

/// The diameters that models_info.json gives are a check of the meshes' unit.
void check_diameters(const fs::path& folder, const std::vector<Model>& models) {
  const fs::path file = folder / "models_info.json";
  if (!fs::exists(file)) return;
  const nlohmann::json document = read_json(file);
  const JsonField root(document, file.string());
  constexpr double kAgreement = 0.02;  // some tools list the diagonal of sampled points
  for (const Model& model : models) {
    const std::string key = std::to_string(model.id);
    if (!root.has(key) || !root[key].has("diameter")) continue;
    const double diameter = root[key]["diameter"].number();
    if (std::abs(diameter - model.diameter) <= kAgreement * model.diameter) continue;
    root[key]["diameter"].fail(
        fmt::format("{:g} mm, but the mesh of model {} is {:g} mm across; expected equal sizes in "
                    "mm",
                    diameter, model.id, model.diameter));
  }
}

void check_no_twins(const fs::path& folder, const std::vector<Model>& models) {
  for (std::size_t i = 0; i < models.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!congruences(models[j], models[i]).empty())
        throw Error(fmt::format(
            "{}: models {} ({}) and {} ({}) are the same shape; expected each "
            "shape once",
            folder.string(), models[j].id, models[j].name, models[i].id, models[i].name));
}

}  // namespace

std::vector<Model> read_library(const fs::path& folder) {
  const std::map<int, fs::path> files = mesh_files(folder);
  const std::map<int, std::string> names = read_names(folder);
  std::vector<Model> models;
  for (const auto& [id, file] : files) {
    models.push_back(build_model(id, file.string(), read_mesh(file)));
    const auto name = names.find(id);
    models.back().name = name == names.end() ? file.stem().string() : name->second;
  }
  check_diameters(folder, models);
  check_no_twins(folder, models);
  return models;
}

}  // namespace trihedron
