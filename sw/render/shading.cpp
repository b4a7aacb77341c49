// SPDX-License-Identifier: Apache-2.0
#include "render/shading.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/random.hpp"

namespace trihedron::render {
namespace {

constexpr int kSamples = kSubsamples * kSubsamples;
constexpr double kLift_mm = 1e-3;   // shadow rays start this far off their own surface
constexpr double kSkyShare = 0.25;  // ambient light comes from above more than from below

// Where sample k of a pixel looks on the light: a permutation, so that the samples of one quarter
// of the pixel see all quarters of the light.
int light_cell(int k) { return (k * 7 + 3) % kSamples; }

// One sample of each quarter of the pixel.
const std::vector<int> kQuarters{0, 2, 8, 10};
const std::vector<int> kAll{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

// The unit disc, area true, from the unit square (concentric map).
Eigen::Vector2d disc(double u, double v) {
  const double a = 2 * u - 1, b = 2 * v - 1;
  if (a == 0 && b == 0) return {0, 0};
  constexpr double kQuarterPi = 0.7853981633974483;
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b;
  const double angle = wide ? kQuarterPi * b / a : 2 * kQuarterPi - kQuarterPi * a / b;
  return {r * std::cos(angle), r * std::sin(angle)};
}

}  // namespace

Shader::Shader(const World& world) : world_(world), occlusion_(world) {
  materials_.push_back({Eigen::Vector3d::UnitZ(), world.table.albedo});
  for (const PlacedObject& object : world.objects)
    for (const Surface& surface : object.model->surfaces)
      materials_.push_back({object.world_from_model.R * surface.normal, object.albedo});
}

Shader::Point Shader::resolve(const ShadingSample& sample) const {
  if (sample.surface > 0) return {sample.point, &materials_[sample.surface]};
  const Eigen::Vector3d &o = sample.ray_origin, &d = sample.ray_direction;
  const Table& table = world_.table;
  if (!table.present || d.z() == 0) return {};
  const double s = -o.z() / d.z();
  const Eigen::Vector3d p = o + s * d;
  const bool on_table = s > 0 && p.x() >= table.min.x() && p.x() <= table.max.x() &&
                        p.y() >= table.min.y() && p.y() <= table.max.y();
  if (!on_table) return {};
  return {p, &materials_[0]};
}

// Irradiance from one light, on albedo 1. Falls off with the squared distance, relative to that of
// the world's origin, so `intensity` means the same wherever the light stands.
double Shader::light(const Point& point, int light, const Eigen::Vector2d& on_disc,
                     int& shadowed) const {
  const Light& lamp = world_.lights[light];
  const Eigen::Vector3d axis = lamp.position.normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const Eigen::Vector3d source =
      lamp.position + lamp.radius_mm * (on_disc.x() * u + on_disc.y() * v);
  const Eigen::Vector3d to_light = source - point.position;
  const double cosine = point.material->normal.dot(to_light.normalized());
  if (cosine <= 0) return 0;
  if (lamp.casts_shadows &&
      occlusion_.blocked(point.position + kLift_mm * point.material->normal, source)) {
    ++shadowed;
    return 0;
  }
  return lamp.intensity * cosine * lamp.position.squaredNorm() / to_light.squaredNorm();
}

double Shader::sum(const std::vector<ShadingSample>& samples, const std::vector<int>& which,
                   std::uint64_t pixel_seed, bool& partly_shadowed) const {
  Random random(pixel_seed);
  const double shift_u = random.uniform(), shift_v = random.uniform();
  std::vector<int> shadowed(world_.lights.size(), 0);
  double grey = 0;
  for (int k : which) {
    const Point point = resolve(samples[k]);
    if (point.material == nullptr) {
      grey += world_.background;
      continue;
    }
    const int cell = light_cell(k);
    const Eigen::Vector2d on_disc = disc((cell % kSubsamples + shift_u) / kSubsamples,
                                         (cell / kSubsamples + shift_v) / kSubsamples);
    double irradiance = world_.ambient * (1 + kSkyShare * point.material->normal.z());
    for (std::size_t l = 0; l < world_.lights.size(); ++l)
      irradiance += light(point, static_cast<int>(l), on_disc, shadowed[l]);
    grey += point.material->albedo * irradiance;
  }
  const int count = static_cast<int>(which.size());
  partly_shadowed =
      std::any_of(shadowed.begin(), shadowed.end(), [count](int n) { return n > 0 && n < count; });
  return grey / count;
}

double Shader::pixel(const std::vector<ShadingSample>& samples, std::uint64_t pixel_seed) const {
  // On an object, inside a surface and outside penumbras four samples say as much as sixteen.
  bool partly_shadowed = false;
  const std::uint16_t surface = samples[0].surface;
  const bool one_surface = std::all_of(samples.begin(), samples.end(),
                                       [surface](const auto& s) { return s.surface == surface; });
  if (one_surface) {
    const bool on_table = resolve(samples[0]).material != nullptr;
    const bool one_material =
        surface > 0 || (resolve(samples[kSamples - 1]).material != nullptr) == on_table;
    const double grey = sum(samples, kQuarters, pixel_seed, partly_shadowed);
    if (one_material && !partly_shadowed) return grey;
  }
  return sum(samples, kAll, pixel_seed, partly_shadowed);
}

}  // namespace trihedron::render
