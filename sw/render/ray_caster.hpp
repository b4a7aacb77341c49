// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "recognition/camera.hpp"
#include "render/world.hpp"

namespace trihedron::render {

/// One row of samples: what each sees.
struct SampleRow {
  std::vector<double> x, y;            ///< direction (x, y, 1) in the camera frame (pinhole), or
                                       ///< position (x, y) in it, mm (orthographic)
  std::vector<double> depth;           ///< camera z of the nearest surface, mm; infinite: none
  std::vector<std::uint16_t> surface;  ///< 1 + index into the scene's surfaces; 0: no object
  std::vector<std::int64_t> alone;     ///< per object: samples it covers, hidden or not
};

/// Exact visibility of a scene's surfaces from one camera: every sample is tested against every
/// triangle whose bounding box holds it. Both projections reduce to the same test: with
/// d = (x, y, 1) and the triangle's corners a, b, c in the camera frame (orthographic: their z
/// set to 1), the sample is inside when d . (a x b), d . (b x c) and d . (c x a) agree in sign.
/// Two neighbours have exactly opposite products at their edge, so there are no cracks.
class ViewCaster {
 public:
  ViewCaster(const World& world, const Camera& camera);
  /// Casts sample row `row`, 0 .. kSubsamples * camera.height_px - 1.
  void cast(int row, SampleRow& out) const;
  /// The world position of a point seen at (x, y) of a SampleRow in depth z mm.
  Eigen::Vector3d world_point(double x, double y, double z) const;

 private:
  struct Facet {
    std::array<Eigen::Vector3d, 3> edges;  ///< a x b, b x c, c x a
    Eigen::Vector3d normal;                ///< camera frame, not normalised
    double offset = 0;                     ///< normal . a
    int object = 0;
    std::uint16_t surface = 0;
    int x0 = 0, x1 = -1, y0 = 0, y1 = -1;  ///< samples it may cover, inclusive
  };
  void add_facet(const std::array<Eigen::Vector3d, 3>& corners, int object, std::uint16_t surface);
  void bound(Facet& facet, const std::array<Eigen::Vector3d, 3>& corners) const;
  void cast_facet(const Facet& facet, SampleRow& out, std::vector<char>& covered) const;

  Camera camera_;
  bool orthographic_;
  int object_count_;
  std::vector<Facet> facets_;  ///< those that face the camera, by object
  Eigen::Matrix3d inverse_k_;
};

/// Says whether anything lies between two points of a scene.
class Occlusion {
 public:
  explicit Occlusion(const World& world);
  /// True when a triangle crosses the segment from `from` to `to` (world, mm; ends excluded).
  bool blocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  struct Body {
    Eigen::Vector3d centre;
    double radius_squared = 0;
    std::vector<std::array<Eigen::Vector3d, 3>> triangles;  ///< a corner and two edge vectors
  };
  std::vector<Body> bodies_;
};

}  // namespace trihedron::render
