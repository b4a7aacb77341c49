// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "io/library.hpp"

namespace trihedron::cli {
namespace {

struct Arguments {
  std::string folder;
  bool surfaces = false, json = false, quiet = false;
};

std::size_t edges_of(const Surface& surface) {
  std::size_t count = 0;
  for (const auto& loop : surface.loops) count += loop.size();
  return count;
}

template <typename Value>
auto range(const Model& model, Value value) {
  auto low = value(model.surfaces[0]), high = low;
  for (const Surface& surface : model.surfaces) {
    low = std::min(low, value(surface));
    high = std::max(high, value(surface));
  }
  return std::pair(low, high);
}

void print_model(const Model& model, bool surfaces) {
  const auto area = range(model, [](const Surface& s) { return s.area; });
  const auto edges = range(model, [](const Surface& s) { return edges_of(s); });
  const auto convex = std::count_if(model.edges.begin(), model.edges.end(),
                                    [](const ModelEdge& e) { return e.convex; });
  fmt::print(
      "{:>4}  {:<20} {:>8} {:>6} {:>8} {:>9.1f}  {:>8.1f} {:>8.1f}  {:>2} {:>3}  {:>6} {:>5}\n",
      model.id, model.name, model.surfaces.size(), model.edges.size(), model.mesh.vertices.size(),
      model.diameter, area.first, area.second, edges.first, edges.second,
      static_cast<long>(model.edges.size()) - convex, model.symmetries.size());
  if (!surfaces) return;
  for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
    const Surface& s = model.surfaces[i];
    fmt::print(
        "      surface {:>3}: area {:9.2f} mm2, perimeter {:7.2f} mm, {:>2} edges, {} hole{}, "
        "normal ({:6.3f} {:6.3f} {:6.3f}), centroid ({:7.2f} {:7.2f} {:7.2f}) mm\n",
        i, s.area, s.perimeter, edges_of(s), s.loops.size() - 1, s.loops.size() == 2 ? "" : "s",
        s.normal.x(), s.normal.y(), s.normal.z(), s.centroid.x(), s.centroid.y(), s.centroid.z());
  }
}

nlohmann::ordered_json to_json(const Model& model) {
  nlohmann::ordered_json out = {{"id", model.id},
                                {"name", model.name},
                                {"diameter_mm", model.diameter},
                                {"vertices", model.mesh.vertices.size()},
                                {"edges", model.edges.size()},
                                {"symmetries", model.symmetries.size()}};
  out["surfaces"] = nlohmann::ordered_json::array();
  for (const Surface& s : model.surfaces)
    out["surfaces"].push_back({{"area_mm2", s.area},
                               {"perimeter_mm", s.perimeter},
                               {"edges", edges_of(s)},
                               {"holes", s.loops.size() - 1},
                               {"normal", {s.normal.x(), s.normal.y(), s.normal.z()}},
                               {"centroid_mm", {s.centroid.x(), s.centroid.y(), s.centroid.z()}}});
  return out;
}

void run(const Arguments& arguments) {
  const std::vector<Model> library = read_library(arguments.folder);
  if (arguments.quiet) return;
  if (arguments.json) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const Model& model : library) out.push_back(to_json(model));
    fmt::print("{}\n", out.dump(1));
    return;
  }
  fmt::print("{:>4}  {:<20} {:>8} {:>6} {:>8} {:>9}  {:>17}  {:>6}  {:>6} {:>5}\n", "", "", "", "",
             "", "diameter", "area of a surface", "edges", "inner", "sym-");
  fmt::print("{:>4}  {:<20} {:>8} {:>6} {:>8} {:>9}  {:>8} {:>8}  {:>2} {:>3}  {:>6} {:>5}\n", "id",
             "name", "surfaces", "edges", "vertices", "mm", "min mm2", "max mm2", "of", "one",
             "edges", "metry");
  for (const Model& model : library) print_model(model, arguments.surfaces);
}

}  // namespace

void add_models(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("models", "The models of a library and their attributes");
  command->add_option("DIR", arguments->folder, "Folder of meshes (PLY, OBJ, STL, OFF; mm)")
      ->required();
  command->add_flag("--surfaces", arguments->surfaces, "List every surface");
  command->add_flag("--json", arguments->json, "Print as JSON, surfaces included");
  command->add_flag("--quiet", arguments->quiet, "Print nothing: only check the meshes");
  command->footer("Example:\n  trihedron models testvectors/models10 --surfaces");
  command->callback([arguments, &exit_code] {
    run(*arguments);
    exit_code = kDone;
  });
}

}  // namespace trihedron::cli
