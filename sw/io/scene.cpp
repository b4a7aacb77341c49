// SPDX-License-Identifier: Apache-2.0
#include "io/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/image.hpp"
#include "io/json_field.hpp"
#include "io/scene_cameras.hpp"

namespace trihedron {
namespace {

namespace fs = std::filesystem;

std::optional<int> parse_id(const std::string& text) {
  int id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || end != text.data() + text.size() || id < 0) return std::nullopt;
  return id;
}

fs::path image_file(const fs::path& folder, int im_id) {
  const std::string stem = fmt::format("{:06d}", im_id);
  for (const char* sub : {"gray", "rgb"})
    for (const char* ending : {".png", ".tif", ".tiff", ".jpg", ".bmp", ".pgm"})
      if (fs::exists(folder / sub / (stem + ending))) return folder / sub / (stem + ending);
  return folder / "gray" / (stem + ".png");  // names what was expected
}

void check_equal_sizes(const Scene& scene, const std::vector<ViewCamera>& views) {
  const cv::Size first = scene.images[0].size();
  const auto says_size = [](const ViewCamera& view) {
    return view.camera.width_px != 0 && view.camera.height_px != 0;
  };
  for (std::size_t v = 1; v < scene.images.size(); ++v) {
    if (scene.images[v].size() == first || (says_size(views[0]) && says_size(views[v]))) continue;
    throw Error(fmt::format(
        "{}: its image is {} x {} px, but that of view {} is {} x {} px; expected equal sizes, or "
        "width and height in both entries",
        views[v].place, scene.images[v].cols, scene.images[v].rows, views[0].im_id, first.width,
        first.height));
  }
}

void read_views(const fs::path& folder, Scene& scene) {
  const std::vector<ViewCamera> views = read_cameras(folder / "scene_camera.json");
  for (const ViewCamera& view : views) {
    const fs::path image = image_file(folder, view.im_id);
    scene.images.push_back(read_grey(image));
    const cv::Size size = scene.images.back().size();
    check_image_size(view.camera, view.place, image.string(), size.width, size.height);
    scene.im_ids.push_back(view.im_id);
    scene.cameras.push_back(view.camera);
    scene.cameras.back().width_px = size.width;
    scene.cameras.back().height_px = size.height;
  }
  check_equal_sizes(scene, views);
}

void read_truth(const fs::path& folder, Scene& scene) {
  const fs::path file = folder / "scene_gt.json";
  if (!fs::exists(file)) return;
  const nlohmann::json document = read_json(file);
  const JsonField root(document, file.string());
  scene.truth.emplace();
  for (std::size_t v = 0; v < scene.im_ids.size(); ++v) {
    const std::string key = std::to_string(scene.im_ids[v]);
    if (!root.has(key)) continue;
    for (const JsonField& object : root[key].items()) {
      const Transform camera_from_model = parse_motion(object, "cam_R_m2c", "cam_t_m2c");
      scene.truth->push_back({object["obj_id"].integer(),
                              scene.cameras[v].camera_from_world.inverse() * camera_from_model});
    }
    return;  // one view tells all: the poses of the others repeat them
  }
  root.fail("holds none of the views of scene_camera.json");
}

/// "look[-hd]-isolated", "-multi" or "-stacked": the sets in which results are listed.
void read_kind(const fs::path& folder, Scene& scene) {
  const fs::path file = folder / "scene_kind.json";
  if (!fs::exists(file)) return;
  const nlohmann::json document = read_json(file);
  const JsonField root(document, file.string());
  const bool hd = root.has("rig") && root["rig"].text() == "hd";
  const bool stacked = root.has("stacked") && root["stacked"].integer() != 0 && !hd;
  const bool several = root.has("objects") && root["objects"].integer() > 1;
  scene.kind = root["look"].text() + (hd ? "-hd" : "") +
               (stacked   ? "-stacked"
                : several ? "-multi"
                          : "-isolated");
}

bool is_scene(const fs::path& folder) { return fs::exists(folder / "scene_camera.json"); }

void find_scenes(const fs::path& folder, int levels, std::vector<fs::path>& out) {
  if (is_scene(folder)) {
    out.push_back(folder);
    return;
  }
  if (levels == 0) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) find_scenes(entry.path(), levels - 1, out);
}

}  // namespace

Scene read_scene(const fs::path& folder) {
  require_folder(folder, "a scene with scene_camera.json and gray/000000.png ...");
  Scene scene;
  scene.name = fs::absolute(folder / "").lexically_normal().parent_path().filename().string();
  scene.id = parse_id(scene.name).value_or(0);
  read_views(folder, scene);
  read_truth(folder, scene);
  read_kind(folder, scene);
  return scene;
}

std::vector<fs::path> find_scenes(const fs::path& dataset) {
  require_folder(dataset, "a folder of scenes");
  std::vector<fs::path> out;
  constexpr int kLevels = 2;
  find_scenes(dataset, kLevels, out);
  if (out.empty())
    throw Error(dataset.string() + ": no scenes in this folder; expected NNNNNN/scene_camera.json");
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace trihedron
