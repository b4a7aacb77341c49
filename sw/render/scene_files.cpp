// SPDX-License-Identifier: Apache-2.0
#include "render/scene_files.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/image.hpp"
#include "io/json_field.hpp"
#include "io/scene_cameras.hpp"

namespace trihedron::render {
namespace {

using nlohmann::json;

json row_major(const Eigen::Matrix3d& m) {
  json out = json::array();
  for (int i = 0; i < 9; ++i) out.push_back(m(i / 3, i % 3));
  return out;
}

json numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json object_entry(const PlacedObject& object, const Camera& camera) {
  const Transform camera_from_model = camera.camera_from_world * object.world_from_model;
  return {{"obj_id", object.model->id},
          {"cam_R_m2c", row_major(camera_from_model.R)},
          {"cam_t_m2c", numbers(camera_from_model.t)}};
}

json surface_table(const World& world) {
  json table = json::array();
  for (std::size_t o = 0; o < world.objects.size(); ++o) {
    const PlacedObject& object = world.objects[o];
    for (std::size_t s = 0; s < object.model->surfaces.size(); ++s) {
      const Eigen::Vector3d n = object.world_from_model.R * object.model->surfaces[s].normal;
      table.push_back({{"object", o}, {"surface", s}, {"normal", numbers(n)}});
    }
  }
  return table;
}

// The size that puts the principal point into the middle, for files that give none.
int middle_size(double principal_px) { return static_cast<int>(std::lround(2 * principal_px)) + 1; }

}  // namespace

void write_scene(const std::filesystem::path& folder, const RenderedScene& scene) {
  std::filesystem::remove(folder / "scene_camera.json");  // no mixture of two scenes if interrupted
  make_folder(folder / "gray");
  make_folder(folder / "surfaces");
  json truth, info;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const std::string key = std::to_string(v), name = fmt::format("{:06}.png", v);
    write_png(folder / "gray" / name, scene.views[v].gray);
    write_png(folder / "surfaces" / name, scene.views[v].surfaces);
    truth[key] = info[key] = json::array();
    for (std::size_t o = 0; o < scene.world.objects.size(); ++o) {
      truth[key].push_back(object_entry(scene.world.objects[o], scene.cameras[v]));
      info[key].push_back({{"visib_fract", scene.views[v].visible_fraction[o]}});
    }
  }
  const json kind{{"look", scene.look},
                  {"rig", scene.rig},
                  {"objects", scene.world.objects.size()},
                  {"stacked", scene.stacked ? 1 : 0},
                  {"leaning", scene.leaning ? 1 : 0}};
  write_whole(folder / "scene_gt.json", truth.dump(1));
  write_whole(folder / "scene_gt_info.json", info.dump(1));
  write_whole(folder / "scene_kind.json", kind.dump());
  write_whole(folder / "surface_table.json", surface_table(scene.world).dump(1));
  // Last: a folder is a scene once it has this file, and then it is a whole one.
  write_cameras(folder / "scene_camera.json", scene.reported_cameras);
}

std::vector<Camera> read_cameras(const std::filesystem::path& file) {
  std::vector<Camera> cameras;
  for (const ViewCamera& view : trihedron::read_cameras(file)) {
    cameras.push_back(view.camera);
    Camera& camera = cameras.back();
    if (camera.width_px == 0) camera.width_px = middle_size(camera.K(0, 2));
    if (camera.height_px == 0) camera.height_px = middle_size(camera.K(1, 2));
  }
  return cameras;
}

std::vector<PlacedObject> read_objects(const std::filesystem::path& file,
                                       const std::vector<Camera>& cameras,
                                       const std::vector<Model>& library) {
  const json document = read_json(file);
  const JsonField root(document, file.string());
  const std::vector<int> views = view_numbers(root);
  if (views.empty()) root.fail("holds no view; expected \"0\", \"1\", \"2\" ...");
  std::vector<PlacedObject> objects;
  for (const JsonField& entry : root[std::to_string(views.front())].items()) {
    const int id = entry["obj_id"].integer();
    const auto model =
        std::find_if(library.begin(), library.end(), [id](const Model& m) { return m.id == id; });
    if (model == library.end())
      entry["obj_id"].fail(fmt::format("expected a model of the library, which has no id {}", id));
    const Transform camera_from_model = parse_motion(entry, "cam_R_m2c", "cam_t_m2c");
    objects.push_back({&*model, cameras[0].camera_from_world.inverse() * camera_from_model, 1});
  }
  return objects;
}

}  // namespace trihedron::render
