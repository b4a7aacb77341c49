// SPDX-License-Identifier: Apache-2.0
#include "render/placement.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "golden/error.hpp"
#include "render/contact.hpp"
#include "render/rest.hpp"

namespace trihedron::render {
namespace {

constexpr double kSteadiness_rad = 0.10;  // less than 6 degrees: a touch throws it over
constexpr int kTriesPerObject = 60, kTriesPerScene = 500;

// Finds room for one object after the other.
class Placer {
 public:
  Placer(const std::vector<Model>& library, const std::vector<Camera>& cameras, const Field& field,
         const PlacementOptions& options, Random& random)
      : library_(library), cameras_(cameras), field_(field), options_(options), random_(random) {
    for (const Model& model : library) poses_.push_back(stable_poses(model.mesh, kSteadiness_rad));
  }

  // A whole scene, or nothing when an object found no room.
  std::optional<std::vector<PlacedObject>> scene() {
    objects_.clear();
    bodies_.clear();
    standing_.clear();
    used_.assign(library_.size(), 0);
    while (static_cast<int>(objects_.size()) < options_.objects)
      if (!add()) return std::nullopt;
    return objects_;
  }

 private:
  bool add() {
    const int index = static_cast<int>(objects_.size());
    const bool on_top = options_.stacked && index == 1;
    const bool leans = options_.leaning && index == (options_.stacked ? 2 : 1);
    for (int attempt = 0; attempt < kTriesPerObject; ++attempt) {
      const int m = random_.below(static_cast<int>(library_.size()));
      if (poses_[m].empty() || (used_[m] && !options_.repeat_models)) continue;
      const StablePose& pose = poses_[m][random_.below(static_cast<int>(poses_[m].size()))];
      PlacedObject object{&library_[m], {}, 1};
      const auto place = on_top  ? rest_on_top(*object.model, pose, bodies_[0], random_)
                         : leans ? lean_against(*object.model, pose, bodies_[0], random_)
                                 : rest_on_table(*object.model, pose, field_, random_);
      if (!place) continue;
      object.world_from_model = *place;
      const Body body = make_body(object);
      const bool standing = !on_top && !leans;
      if (!seen_whole(body) || !has_room(body, standing)) continue;
      objects_.push_back(object);
      bodies_.push_back(body);
      standing_.push_back(standing);
      used_[m] = 1;
      return true;
    }
    return false;
  }

  bool seen_whole(const Body& body) const {
    const double margin = options_.image_margin_px;
    for (const Camera& camera : cameras_)
      for (const Eigen::Vector3d& v : body.vertices) {
        if (camera.projection == Camera::Projection::kPinhole &&
            (camera.camera_from_world * v).z() <= 0)
          return false;
        const Eigen::Vector2d p = camera.project(v);
        if (p.x() < margin || p.y() < margin || p.x() > camera.width_px - 1 - margin ||
            p.y() > camera.height_px - 1 - margin)
          return false;
      }
    return true;
  }

  bool has_room(const Body& body, bool standing) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (interpenetrate(body, bodies_[i])) return false;
      if (standing && standing_[i] && gap_in_plan(body, bodies_[i]) < options_.gap_mm) return false;
    }
    return true;
  }

  const std::vector<Model>& library_;
  const std::vector<Camera>& cameras_;
  const Field field_;
  const PlacementOptions options_;
  Random& random_;
  std::vector<std::vector<StablePose>> poses_;  // per model
  std::vector<PlacedObject> objects_;
  std::vector<Body> bodies_;
  std::vector<char> standing_;  // on the table, on its own
  std::vector<char> used_;      // models
};

void check(const std::vector<Model>& library, const PlacementOptions& options) {
  if (library.empty()) throw Error("render: the model library is empty; there is nothing to place");
  if (options.objects < 1)
    throw Error("render: " + std::to_string(options.objects) + " objects; a scene needs 1 or more");
  const int needed = 1 + (options.stacked ? 1 : 0) + (options.leaning ? 1 : 0);
  if (options.objects < needed)
    throw Error("render: stacked or leaning scenes of this kind need " + std::to_string(needed) +
                " objects or more, not " + std::to_string(options.objects));
  if (!options.repeat_models && options.objects > static_cast<int>(library.size()))
    throw Error("render: " + std::to_string(options.objects) +
                " different objects from a library of " + std::to_string(library.size()) +
                " models; place fewer or let models repeat");
}

}  // namespace

std::vector<PlacedObject> place_objects(const std::vector<Model>& library,
                                        const std::vector<Camera>& cameras, const Field& field,
                                        const PlacementOptions& options, Random& random) {
  check(library, options);
  Placer placer(library, cameras, field, options, random);
  for (int attempt = 0; attempt < kTriesPerScene; ++attempt)
    if (auto objects = placer.scene()) return *objects;
  throw Error("render: no room for " + std::to_string(options.objects) +
              " objects of this library in the cameras' field; place fewer, or use a larger rig");
}

}  // namespace trihedron::render
