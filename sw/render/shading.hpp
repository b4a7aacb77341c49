// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "render/ray_caster.hpp"
#include "render/world.hpp"

namespace trihedron::render {

/// One sample of a pixel: what it sees and where.
struct ShadingSample {
  std::uint16_t surface = 0;      ///< as SampleRow::surface
  Eigen::Vector3d point;          ///< world, mm; on the object (surface > 0)
  Eigen::Vector3d ray_origin;     ///< world, mm; for what lies behind the objects
  Eigen::Vector3d ray_direction;  ///< world
};

/// Grey levels of a scene: Lambert's law with point and disc lights, cast shadows, ambient light.
class Shader {
 public:
  explicit Shader(const World& world);
  /// Mean grey level (not rounded, not clipped) of a pixel's kSubsamples^2 samples, row by row.
  /// `pixel_seed` decides where the discs are sampled.
  double pixel(const std::vector<ShadingSample>& samples, std::uint64_t pixel_seed) const;

 private:
  struct Material {
    Eigen::Vector3d normal;  ///< world
    double albedo = 0;
  };
  struct Point {
    Eigen::Vector3d position;
    const Material* material = nullptr;  ///< null: background
  };
  Point resolve(const ShadingSample& sample) const;
  double light(const Point& point, int light, const Eigen::Vector2d& on_disc, int& shadowed) const;
  double sum(const std::vector<ShadingSample>& samples, const std::vector<int>& which,
             std::uint64_t pixel_seed, bool& partly_shadowed) const;

  const World& world_;
  Occlusion occlusion_;
  std::vector<Material> materials_;  ///< 0: the table; then by surface
};

}  // namespace trihedron::render
