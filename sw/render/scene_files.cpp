// SPDX-License-Identifier: Apache-2.0
#include "render/scene_files.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "golden/error.hpp"
#include "io/file.hpp"
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

json camera_entry(const Camera& camera) {
  json entry{{"cam_K", row_major(camera.K)},
             {"cam_R_w2c", row_major(camera.camera_from_world.R)},
             {"cam_t_w2c", numbers(camera.camera_from_world.t)},
             {"depth_scale", 1.0},
             {"view", camera.view},
             {"width", camera.width_px},
             {"height", camera.height_px}};
  if (camera.projection == Camera::Projection::kOrthographic) {
    entry["cam_model"] = "orthographic";
    entry["px_per_mm"] = camera.px_per_mm;
  }
  const auto& d = camera.distortion;
  if (std::any_of(d.begin(), d.end(), [](double k) { return k != 0; })) entry["cam_dist"] = d;
  return entry;
}

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

void write_image(const std::filesystem::path& file, const cv::Mat& image) {
  if (!cv::imwrite(file.string(), image))
    throw Error(file.string() + ": cannot be written; is the disk full or the folder read-only?");
}

// The view numbers of a BOP file, ascending.
std::vector<int> view_numbers(const JsonField& root) {
  std::vector<int> views;
  for (const std::string& key : root.keys()) {
    if (key.empty() || key.size() > 6 || key.find_first_not_of("0123456789") != std::string::npos)
      root.fail("\"" + key + "\" is not a view number; expected \"0\", \"1\", \"2\" ...");
    views.push_back(std::stoi(key));
  }
  std::sort(views.begin(), views.end());
  if (views.empty()) root.fail("expected views \"0\", \"1\", \"2\" ...");
  return views;
}

// The size that puts the principal point into the middle, for files that give none.
int middle_size(double principal_px) { return static_cast<int>(std::lround(2 * principal_px)) + 1; }

}  // namespace

void write_scene(const std::filesystem::path& folder, const RenderedScene& scene) {
  make_folder(folder / "gray");
  make_folder(folder / "surfaces");
  json cameras, truth, info;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const std::string key = std::to_string(v), name = fmt::format("{:06}.png", v);
    write_image(folder / "gray" / name, scene.views[v].gray);
    write_image(folder / "surfaces" / name, scene.views[v].surfaces);
    cameras[key] = camera_entry(scene.reported_cameras[v]);
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
  write_whole(folder / "scene_camera.json", cameras.dump(1));
  write_whole(folder / "scene_gt.json", truth.dump(1));
  write_whole(folder / "scene_gt_info.json", info.dump(1));
  write_whole(folder / "scene_kind.json", kind.dump());
  write_whole(folder / "surface_table.json", surface_table(scene.world).dump(1));
}

std::vector<Camera> read_cameras(const std::filesystem::path& file) {
  const json document = read_json(file);
  const JsonField root(document, file.string());
  std::vector<Camera> cameras;
  for (int view : view_numbers(root)) {
    Camera camera = parse_camera(root[std::to_string(view)]);
    if (camera.width_px == 0) camera.width_px = middle_size(camera.K(0, 2));
    if (camera.height_px == 0) camera.height_px = middle_size(camera.K(1, 2));
    cameras.push_back(camera);
  }
  if (cameras.size() < 2) root.fail("expected the cameras of two views or more");
  return cameras;
}

std::vector<PlacedObject> read_objects(const std::filesystem::path& file,
                                       const std::vector<Camera>& cameras,
                                       const std::vector<Model>& library) {
  const json document = read_json(file);
  const JsonField root(document, file.string());
  std::vector<PlacedObject> objects;
  for (const JsonField& entry : root[std::to_string(view_numbers(root).front())].items()) {
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
