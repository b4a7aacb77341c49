// SPDX-License-Identifier: Apache-2.0
#include "render/rig.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "golden/error.hpp"

namespace trihedron::render {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kAcross_mm = 12, kAlong_mm = 3, kTarget_mm = 2, kRoll_rad = kDegree;
constexpr double kObliqueElevation_rad = 40 * kDegree;

struct RigSpec {
  int width_px, height_px;
  double focal_px, distance_mm;
  Eigen::Vector2d table_centre;  // world, mm
  double aim_height_mm;          // the side and front cameras look at this height
};

RigSpec spec(const std::string& name) {
  if (name == "paper") return {450, 300, 1228.4, 600, {110, 73}, 60};
  if (name == "hd") return {1280, 960, 2100, 700, {190, 142}, 90};
  throw Error("rig '" + name + "' is not known; it must be paper or hd");
}

// Where camera `index` stands, seen from what it looks at, and the direction of its image's x.
struct Station {
  std::string view;
  Eigen::Vector3d from_target, right;
};

Station station(int index) {
  if (index == 0) return {"top", Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()};
  if (index == 1) return {"side", -Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()};
  if (index == 2) return {"front", Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
  // Oblique cameras: between the standard ones first, then ever finer around the table.
  const double azimuth = (-45 + 90.0 * (index - 3) + 45.0 * ((index - 3) / 4)) * kDegree;
  const double c = std::cos(kObliqueElevation_rad), s = std::sin(kObliqueElevation_rad);
  return {"oblique" + std::to_string(index - 2),
          {c * std::cos(azimuth), c * std::sin(azimuth), s},
          {-std::sin(azimuth), std::cos(azimuth), 0}};
}

Transform look_at(const Eigen::Vector3d& centre, const Eigen::Vector3d& target,
                  const Eigen::Vector3d& right, double roll) {
  const Eigen::Vector3d z = (target - centre).normalized();
  const Eigen::Vector3d y0 = z.cross(right).normalized();
  const Eigen::Vector3d x0 = y0.cross(z);
  Transform camera_from_world;
  camera_from_world.R.row(0) = std::cos(roll) * x0 + std::sin(roll) * y0;
  camera_from_world.R.row(1) = -std::sin(roll) * x0 + std::cos(roll) * y0;
  camera_from_world.R.row(2) = z;
  camera_from_world.t = -(camera_from_world.R * centre);
  return camera_from_world;
}

// A normal offset in the plane of `right` and `up`, in a fixed order of draws.
Eigen::Vector3d normal_across(const Eigen::Vector3d& right, const Eigen::Vector3d& up,
                              Random& random) {
  const double r = random.normal();
  const double u = random.normal();
  return r * right + u * up;
}

Transform pose(const RigSpec& rig, const Station& at, double jitter, Random& random) {
  Eigen::Vector3d target(rig.table_centre.x(), rig.table_centre.y(), 0);
  if (at.view == "side" || at.view == "front") target.z() = rig.aim_height_mm;
  Eigen::Vector3d centre = target + rig.distance_mm * at.from_target;
  const Eigen::Vector3d up = at.from_target.cross(at.right);
  const Eigen::Vector3d across = normal_across(at.right, up, random);
  centre += jitter * (kAcross_mm * across + kAlong_mm * random.normal() * at.from_target);
  target += jitter * kTarget_mm * normal_across(at.right, up, random);
  return look_at(centre, target, at.right, jitter * kRoll_rad * random.normal());
}

}  // namespace

Field rig_field(const std::string& name) {
  const RigSpec rig = spec(name);
  const double mm_per_px = rig.distance_mm / rig.focal_px;
  return {rig.table_centre, Eigen::Vector2d(rig.width_px, rig.height_px) * mm_per_px / 2};
}

std::vector<Camera> make_rig(const RigOptions& options, Random& random) {
  const RigSpec rig = spec(options.name);
  if (options.cameras < 2)
    throw Error("a rig of " + std::to_string(options.cameras) +
                " cameras cannot see depth; give 2 or more");
  std::vector<Camera> cameras;
  for (int i = 0; i < options.cameras; ++i) {
    const Station at = station(i);
    Camera camera;
    camera.view = at.view;
    camera.width_px = rig.width_px;
    camera.height_px = rig.height_px;
    camera.K << rig.focal_px, 0, (rig.width_px - 1) / 2.0, 0, rig.focal_px,
        (rig.height_px - 1) / 2.0, 0, 0, 1;
    if (options.orthographic) {
      camera.projection = Camera::Projection::kOrthographic;
      camera.px_per_mm = rig.focal_px / rig.distance_mm;
    } else {
      camera.distortion = options.distortion;
    }
    camera.camera_from_world = pose(rig, at, options.jitter, random);
    cameras.push_back(camera);
  }
  return cameras;
}

Camera miscalibrated(const Camera& camera, double error_px, Random& random) {
  const Eigen::Vector2d shift{error_px * random.normal(), error_px * random.normal()};
  const double corner_px = std::hypot(camera.width_px, camera.height_px) / 2;
  const double roll = error_px / corner_px * random.normal();
  Camera out = camera;
  Transform error;
  Eigen::Vector3d rotation(0, 0, roll);
  if (camera.projection == Camera::Projection::kOrthographic) {
    error.t << shift / camera.px_per_mm, 0;
  } else {
    rotation.x() = -shift.y() / camera.K(1, 1);
    rotation.y() = shift.x() / camera.K(0, 0);
  }
  if (rotation.norm() > 0)
    error.R = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
  out.camera_from_world = error * camera.camera_from_world;
  return out;
}

}  // namespace trihedron::render
