// SPDX-License-Identifier: Apache-2.0
#include "io/scene_cameras.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <charconv>

#include "golden/error.hpp"
#include "io/file.hpp"

namespace trihedron {
namespace {

using Eigen::Matrix3d;

Matrix3d parse_matrix(const JsonField& field) {
  const std::vector<double> n = field.numbers(9);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(n.data());
}

Matrix3d parse_K(const JsonField& field) {
  const Matrix3d K = parse_matrix(field);
  constexpr double kTiny = 1e-9;
  const bool shape = std::abs(K(1, 0)) < kTiny && std::abs(K(2, 0)) < kTiny &&
                     std::abs(K(2, 1)) < kTiny && std::abs(K(2, 2) - 1) < kTiny;
  if (!shape || K(0, 0) <= 0 || K(1, 1) <= 0)
    field.fail("expected fx s cx 0 fy cy 0 0 1 with fx, fy > 0 px");
  return K;
}

}  // namespace

Transform parse_motion(const JsonField& entry, const std::string& rotation_key,
                       const std::string& translation_key) {
  const JsonField rotation = entry[rotation_key];
  const Matrix3d R = parse_matrix(rotation);
  const double off = (R.transpose() * R - Matrix3d::Identity()).cwiseAbs().maxCoeff();
  constexpr double kWrittenDigits = 1e-3;  // files hold four digits or more
  if (off > kWrittenDigits || R.determinant() < 0)
    rotation.fail(
        fmt::format("not a rotation (R'R differs from 1 by {:.3g}, determinant {:.3g}); "
                    "expected orthonormal rows and determinant +1",
                    off, R.determinant()));
  const Eigen::JacobiSVD<Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const std::vector<double> t = entry[translation_key].numbers(3);
  return {svd.matrixU() * svd.matrixV().transpose(), {t[0], t[1], t[2]}};
}

Camera parse_camera(const JsonField& entry) {
  Camera camera;
  camera.K = parse_K(entry["cam_K"]);
  camera.camera_from_world = parse_motion(entry, "cam_R_w2c", "cam_t_w2c");
  if (entry.has("view")) camera.view = entry["view"].text();
  if (entry.has("cam_dist")) {
    const std::vector<double> lens = entry["cam_dist"].numbers(5);
    std::copy(lens.begin(), lens.end(), camera.distortion.begin());
  }
  if (entry.has("cam_model")) {
    const std::string model = entry["cam_model"].text();
    if (model == "orthographic") {
      camera.projection = Camera::Projection::kOrthographic;
      camera.px_per_mm = entry["px_per_mm"].number();
      if (camera.px_per_mm <= 0) entry["px_per_mm"].fail("expected more than 0 px per mm");
    } else if (model != "pinhole") {
      entry["cam_model"].fail("unknown model \"" + model +
                              "\"; expected \"pinhole\" or \"orthographic\"");
    }
  }
  if (entry.has("width")) camera.width_px = entry["width"].integer();
  if (entry.has("height")) camera.height_px = entry["height"].integer();
  return camera;
}

void check_image_size(const Camera& camera, const std::string& place, const std::string& image_name,
                      int width_px, int height_px) {
  if ((camera.width_px != 0 && camera.width_px != width_px) ||
      (camera.height_px != 0 && camera.height_px != height_px))
    throw Error(fmt::format("{}: width and height say {} x {} px, but {} is {} x {} px", place,
                            camera.width_px, camera.height_px, image_name, width_px, height_px));
  if (camera.projection == Camera::Projection::kOrthographic) return;
  const double x = (camera.K(0, 2) + 0.5) / width_px, y = (camera.K(1, 2) + 0.5) / height_px;
  constexpr double kBorder = 0.05;  // no camera looks past the border of its own image
  if (std::min({x, y, 1 - x, 1 - y}) >= kBorder) return;
  throw Error(fmt::format(
      "{}.cam_K: the principal point ({:g}, {:g}) is not within {}, which is {} x {} px; expected "
      "the image in the size it was calibrated for",
      place, camera.K(0, 2), camera.K(1, 2), image_name, width_px, height_px));
}

std::vector<int> view_numbers(const JsonField& root) {
  std::vector<int> ids;
  for (const std::string& key : root.keys()) {
    int id = -1;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), id);
    if (error != std::errc() || end != key.data() + key.size() || id < 0)
      root.fail("\"" + key + "\" is not a view number; expected \"0\", \"1\", \"2\" ...");
    ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end());
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
    root.fail("a view number occurs twice");
  return ids;
}

std::vector<ViewCamera> read_cameras(const std::filesystem::path& file) {
  const nlohmann::json document = read_json(file);
  const JsonField root(document, file.string());
  const std::vector<int> im_ids = view_numbers(root);
  if (im_ids.size() < 2)
    root.fail(fmt::format("holds {} views; expected at least 2", im_ids.size()));
  constexpr const char* kNames[] = {"top", "side", "front"};
  std::vector<ViewCamera> views;
  for (int im_id : im_ids) {
    const JsonField entry = root[std::to_string(im_id)];
    views.push_back({im_id, parse_camera(entry), entry.place()});
    std::string& name = views.back().camera.view;
    if (name.empty()) name = im_id < 3 ? kNames[im_id] : std::to_string(im_id);
  }
  return views;
}

nlohmann::ordered_json camera_json(const Camera& camera) {
  const auto row_major = [](const Matrix3d& m) {
    std::vector<double> out;
    for (int i = 0; i < 9; ++i) out.push_back(m(i / 3, i % 3));
    return out;
  };
  const Eigen::Vector3d& t = camera.camera_from_world.t;
  nlohmann::ordered_json entry{{"cam_K", row_major(camera.K)},
                               {"cam_R_w2c", row_major(camera.camera_from_world.R)},
                               {"cam_t_w2c", {t.x(), t.y(), t.z()}},
                               {"depth_scale", 1.0},
                               {"view", camera.view},
                               {"width", camera.width_px},
                               {"height", camera.height_px}};
  if (camera.projection == Camera::Projection::kOrthographic) {
    entry["cam_model"] = "orthographic";
    entry["px_per_mm"] = camera.px_per_mm;
  }
  const auto& lens = camera.distortion;
  if (std::any_of(lens.begin(), lens.end(), [](double k) { return k != 0; }))
    entry["cam_dist"] = lens;
  return entry;
}

void write_cameras(const std::filesystem::path& file, const std::vector<Camera>& cameras) {
  nlohmann::ordered_json out;
  for (std::size_t v = 0; v < cameras.size(); ++v) out[std::to_string(v)] = camera_json(cameras[v]);
  write_whole(file, out.dump(1) + "\n");
}

}  // namespace trihedron
