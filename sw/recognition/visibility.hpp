// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recognition/camera.hpp"
#include "recognition/model.hpp"

namespace trihedron {

/// A model standing in the scene.
struct PlacedModel {
  const Model* model = nullptr;
  Transform world_from_model;
};

enum class EdgeType : std::uint8_t {
  kSilhouette,  ///< one adjacent surface faces the camera: the edge hides what lies behind it
  kCrease,      ///< both adjacent surfaces face the camera
};

/// A straight piece of a model edge that a camera sees.
struct VisibleEdge {
  int object = 0;  ///< index of the placed model
  int edge = 0;    ///< index into Model::edges
  EdgeType type = EdgeType::kSilhouette;
  int surface = 0;         ///< the adjacent surface that faces the camera (of a crease: left)
  int other_surface = -1;  ///< of a crease: the other one
  double s0 = 0, s1 = 1;   ///< the piece, as fractions of the model edge from v0 to v1
  Eigen::Vector3d x0_in_world = Eigen::Vector3d::Zero(),
                  x1_in_world = x0_in_world;              ///< its ends, mm
  Eigen::Vector2d x0 = Eigen::Vector2d::Zero(), x1 = x0;  ///< its ends in the image, px
  Eigen::Vector2d normal =
      Eigen::Vector2d::UnitX();  ///< unit, image, at the middle, away from `surface`
  double length_px = 0;
};

/// Behind a surface of another object means behind by more than this, mm: objects that touch
/// must not hide each other's edges because of the error of their poses.
inline constexpr double kContactMm = 1.0;

/// What a camera sees of the edges of `objects`, hidden lines removed, those of the object
/// `only` (all: -1), in the order of objects, edges and positions along the edge. Exact for
/// closed polyhedra that do not penetrate each other. Pieces may leave the image.
std::vector<VisibleEdge> visible_edges(const Camera& camera,
                                       const std::vector<PlacedModel>& objects, int only = -1);

/// Which surface covers each cell of an image: every `kCellPx`-th pixel of every such row.
struct SurfaceMap {
  static constexpr int kCellPx = 2;
  static constexpr std::int32_t kNothing = -1;

  int columns = 0, rows = 0;
  std::vector<std::int32_t> ids;  ///< object * 1024 + surface, or kNothing
  std::vector<float> depths;      ///< camera z, mm

  static int object_of(std::int32_t id) { return id >> 10; }
  static int surface_of(std::int32_t id) { return id & 1023; }
  /// The id at the cell that holds pixel (x, y), kNothing outside the image.
  std::int32_t at(double x_px, double y_px) const;
  /// The depth at a pixel of the image, mm; far beyond everything where nothing is.
  float depth_at(int x_px, int y_px) const {
    return depths[static_cast<std::size_t>(y_px / kCellPx) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(x_px / kCellPx)];
  }
};

/// Draws `objects` as `camera` sees them, nearest surface first.
SurfaceMap surface_map(const Camera& camera, const std::vector<PlacedModel>& objects);

/// What is to be seen of one surface.
struct SurfaceVisibility {
  int cells = 0;          ///< cells of the surface if nothing but its own object hid it
  int visible_cells = 0;  ///< cells that other objects leave
};

/// Per surface of object `index` in `objects`: what `camera` sees of it, other objects hiding it.
std::vector<SurfaceVisibility> surface_visibility(const Camera& camera,
                                                  const std::vector<PlacedModel>& objects,
                                                  int index);

}  // namespace trihedron
