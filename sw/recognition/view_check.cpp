// SPDX-License-Identifier: Apache-2.0
#include "recognition/view_check.hpp"

#include <algorithm>
#include <string>

#include "golden/error.hpp"
#include "recognition/ideal_view.hpp"

namespace trihedron {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The visible volume as half spaces, their normals inwards.
std::vector<Plane> visible_volume(const Camera& camera) {
  const IdealView view(camera);
  const double w = camera.width_px, h = camera.height_px;
  const Vector2d corner[4] = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  const Ray middle = view.ray({w / 2, h / 2});
  const Vector3d inside = middle.origin + middle.direction;
  std::vector<Plane> out;
  for (int k = 0; k < 4; ++k) {
    Plane p = view.plane(corner[k], corner[(k + 1) % 4]);
    if (p.distance(inside) < 0) p = {-p.normal, -p.offset};
    out.push_back(p);
  }
  const Vector3d axis = camera.camera_from_world.R.row(2).transpose();
  out.push_back({axis, camera.camera_from_world.t.z()});
  return out;
}

std::string name_of(const std::vector<View>& views, std::size_t i) {
  return "view " + std::to_string(i) + " (" + views[i].camera.view + ")";
}

std::string size_of(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

bool share_volume(const Camera& a, const Camera& b) {
  std::vector<Plane> planes = visible_volume(a);
  const std::vector<Plane> other = visible_volume(b);
  planes.insert(planes.end(), other.begin(), other.end());
  // Projections onto the violated half spaces in turn converge when they have a common point.
  Vector3d x = Vector3d::Zero();
  for (int round = 0; round < 2000; ++round) {
    double violation = 0;
    for (const Plane& p : planes) {
      const double d = p.distance(x);
      violation = std::min(violation, d);
      if (d < 0) x -= (d - 1e-3) * p.normal;
    }
    if (violation > -1e-3) return true;
  }
  return false;
}

void check_views(const std::vector<View>& views) {
  if (views.size() < 2) {
    throw Error("recognition needs at least two calibrated views, got " +
                std::to_string(views.size()));
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Camera& c = views[i].camera;
    const ViewFeatures& f = views[i].features;
    if (c.width_px != f.width || c.height_px != f.height) {
      throw Error(name_of(views, i) + ": features of " + size_of(f.width, f.height) +
                  " px, but its camera is calibrated for " + size_of(c.width_px, c.height_px));
    }
    const auto beats = static_cast<std::size_t>(f.width) * static_cast<std::size_t>(f.height);
    if (f.contour.size() != beats) {
      throw Error(name_of(views, i) + ": " + std::to_string(f.contour.size()) +
                  " contour beats, expected " + std::to_string(beats) + " for " +
                  size_of(f.width, f.height) + " px");
    }
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    bool shared = false;
    for (std::size_t j = 0; j < views.size() && !shared; ++j) {
      shared = i != j && share_volume(views[i].camera, views[j].camera);
    }
    if (!shared) {
      throw Error(name_of(views, i) +
                  ": its camera sees no volume that another camera sees; check cam_R_w2c and "
                  "cam_t_w2c (world to camera, mm)");
    }
  }
}

}  // namespace trihedron
