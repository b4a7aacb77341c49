// SPDX-License-Identifier: Apache-2.0
#include "render/ray_caster.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace trihedron::render {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNearest_mm = 1;  // what is nearer to a pinhole has no useful projection
constexpr int kEdgeSteps = 8;      // a distorted edge is bounded by the points at these steps
constexpr double kDistortedMargin_px = 4;  // and by how far it may bulge between two of them

double sample_position(int index) { return (index + 0.5) / kSubsamples - 0.5; }

int sample_index(double position) {
  return static_cast<int>(std::floor((position + 0.5) * kSubsamples));
}

}  // namespace

ViewCaster::ViewCaster(const World& world, const Camera& camera)
    : camera_(camera),
      orthographic_(camera.projection == Camera::Projection::kOrthographic),
      object_count_(static_cast<int>(world.objects.size())),
      inverse_k_(camera.K.inverse()) {
  int first_surface = 1;
  for (int o = 0; o < object_count_; ++o) {
    const PlacedObject& object = world.objects[o];
    const Transform camera_from_model = camera.camera_from_world * object.world_from_model;
    const Model& model = *object.model;
    for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
      for (int t : model.surfaces[s].triangles) {
        std::array<Eigen::Vector3d, 3> corners;
        for (int k = 0; k < 3; ++k)
          corners[k] = camera_from_model * model.mesh.vertices[model.mesh.triangles[t][k]];
        add_facet(corners, o, static_cast<std::uint16_t>(first_surface + s));
      }
    }
    first_surface += static_cast<int>(model.surfaces.size());
  }
}

void ViewCaster::add_facet(const std::array<Eigen::Vector3d, 3>& corners, int object,
                           std::uint16_t surface) {
  Facet facet;
  facet.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  facet.offset = facet.normal.dot(corners[0]);
  const double towards_camera = orthographic_ ? facet.normal.z() : facet.offset;
  if (towards_camera >= 0) return;
  facet.object = object;
  facet.surface = surface;
  std::array<Eigen::Vector3d, 3> flat = corners;
  if (orthographic_)
    for (Eigen::Vector3d& corner : flat) corner.z() = 1;
  for (int k = 0; k < 3; ++k) facet.edges[k] = flat[k].cross(flat[(k + 1) % 3]);
  bound(facet, corners);
  if (facet.x0 <= facet.x1 && facet.y0 <= facet.y1) facets_.push_back(facet);
}

void ViewCaster::bound(Facet& facet, const std::array<Eigen::Vector3d, 3>& corners) const {
  const int last_x = camera_.width_px * kSubsamples - 1,
            last_y = camera_.height_px * kSubsamples - 1;
  const bool behind = !orthographic_ && std::any_of(corners.begin(), corners.end(),
                                                    [](auto& c) { return c.z() < kNearest_mm; });
  if (behind) {
    facet.x1 = last_x;
    facet.y1 = last_y;
    return;
  }
  const bool distorted = std::any_of(camera_.distortion.begin(), camera_.distortion.end(),
                                     [](double k) { return k != 0; });
  Eigen::Vector2d low(kInfinity, kInfinity), high(-kInfinity, -kInfinity);
  const int steps = distorted ? kEdgeSteps : 1;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < steps; ++i) {
      const double f = static_cast<double>(i) / steps;
      const Eigen::Vector2d p =
          camera_.project_camera((1 - f) * corners[k] + f * corners[(k + 1) % 3]);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  const double margin = distorted ? kDistortedMargin_px : 1.0 / kSubsamples;
  auto clamped = [](double position, int last) {
    return std::clamp(position, -1.0, last / static_cast<double>(kSubsamples) + 2.0);
  };
  facet.x0 = std::max(0, sample_index(clamped(low.x() - margin, last_x)));
  facet.x1 = std::min(last_x, sample_index(clamped(high.x() + margin, last_x)));
  facet.y0 = std::max(0, sample_index(clamped(low.y() - margin, last_y)));
  facet.y1 = std::min(last_y, sample_index(clamped(high.y() + margin, last_y)));
}

void ViewCaster::cast_facet(const Facet& facet, SampleRow& out, std::vector<char>& covered) const {
  const Eigen::Vector3d &e0 = facet.edges[0], &e1 = facet.edges[1], &e2 = facet.edges[2];
  const Eigen::Vector3d& n = facet.normal;
  for (int i = facet.x0; i <= facet.x1; ++i) {
    const double x = out.x[i], y = out.y[i];
    // A facet that faces the camera has all three products negative or zero inside.
    if (e0.x() * x + e0.y() * y + e0.z() > 0 || e1.x() * x + e1.y() * y + e1.z() > 0 ||
        e2.x() * x + e2.y() * y + e2.z() > 0)
      continue;
    const double depth = orthographic_ ? (facet.offset - n.x() * x - n.y() * y) / n.z()
                                       : facet.offset / (n.x() * x + n.y() * y + n.z());
    if (!(depth > 0)) continue;
    covered[i] = 1;
    if (depth < out.depth[i]) {
      out.depth[i] = depth;
      out.surface[i] = facet.surface;
    }
  }
}

void ViewCaster::cast(int row, SampleRow& out) const {
  const int width = camera_.width_px * kSubsamples;
  out.x.resize(width);
  out.y.resize(width);
  for (int i = 0; i < width; ++i) {
    Eigen::Vector2d pixel(sample_position(i), sample_position(row));
    Eigen::Vector3d d;
    if (orthographic_) {
      d << (pixel.x() - camera_.K(0, 2)) / camera_.px_per_mm,
          (pixel.y() - camera_.K(1, 2)) / camera_.px_per_mm, 1;
    } else {
      d = inverse_k_ * camera_.undistort(pixel).homogeneous();
      d /= d.z();
    }
    out.x[i] = d.x();
    out.y[i] = d.y();
  }
  out.depth.assign(width, kInfinity);
  out.surface.assign(width, 0);
  out.alone.assign(object_count_, 0);
  std::vector<char> covered(width, 0);
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = facets_[f];
    if (row >= facet.y0 && row <= facet.y1) cast_facet(facet, out, covered);
    if (f + 1 == facets_.size() || facets_[f + 1].object != facet.object) {
      out.alone[facet.object] = std::count(covered.begin(), covered.end(), 1);
      std::fill(covered.begin(), covered.end(), 0);
    }
  }
}

Eigen::Vector3d ViewCaster::world_point(double x, double y, double z) const {
  const Eigen::Vector3d x_in_camera =
      orthographic_ ? Eigen::Vector3d(x, y, z) : Eigen::Vector3d(x * z, y * z, z);
  return camera_.camera_from_world.inverse() * x_in_camera;
}

Occlusion::Occlusion(const World& world) {
  for (const PlacedObject& object : world.objects) {
    Body body;
    const Mesh& mesh = object.model->mesh;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(kInfinity), high = -low;
    for (const Eigen::Vector3d& v : mesh.vertices) {
      low = low.cwiseMin(object.world_from_model * v);
      high = high.cwiseMax(object.world_from_model * v);
    }
    body.centre = (low + high) / 2;
    for (const Eigen::Vector3d& v : mesh.vertices) {
      const double distance = (object.world_from_model * v - body.centre).squaredNorm();
      body.radius_squared = std::max(body.radius_squared, distance);
    }
    for (const std::array<int, 3>& t : mesh.triangles) {
      const Eigen::Vector3d a = object.world_from_model * mesh.vertices[t[0]];
      body.triangles.push_back({a, object.world_from_model * mesh.vertices[t[1]] - a,
                                object.world_from_model * mesh.vertices[t[2]] - a});
    }
    bodies_.push_back(std::move(body));
  }
}

bool Occlusion::blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const Eigen::Vector3d d = to - from;
  const double length_squared = d.squaredNorm();
  for (const Body& body : bodies_) {
    const Eigen::Vector3d c = body.centre - from;
    const double along = std::clamp(c.dot(d) / length_squared, 0.0, 1.0);
    if ((c - along * d).squaredNorm() > body.radius_squared) continue;
    for (const auto& [a, u, v] : body.triangles) {
      const Eigen::Vector3d p = d.cross(v);
      const double det = u.dot(p);
      if (det == 0) continue;
      const Eigen::Vector3d s = from - a;
      const double f = s.dot(p) / det;
      if (f < 0 || f > 1) continue;
      const Eigen::Vector3d q = s.cross(u);
      const double g = d.dot(q) / det;
      if (g < 0 || f + g > 1) continue;
      const double t = v.dot(q) / det;
      if (t > 0 && t < 1) return true;
    }
  }
  return false;
}

}  // namespace trihedron::render
