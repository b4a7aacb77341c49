// SPDX-License-Identifier: Apache-2.0
// Draws placed models into a coarse map of surfaces: for areas (what is visible of a surface,
// whose pixel is it), not for edges, which are exact in visibility.cpp.
#include <algorithm>
#include <cmath>

#include "recognition/projected_model.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {
namespace {

/// Depth of the surface's plane along the ray of ideal coordinates (x, y).
double plane_depth(const Camera& camera, const Eigen::Vector3d& normal, double offset,
                   const Eigen::Vector2d& ideal) {
  if (camera.projection == Camera::Projection::kPinhole) {
    return offset / (normal.x() * ideal.x() + normal.y() * ideal.y() + normal.z());
  }
  return (offset - normal.x() * ideal.x() - normal.y() * ideal.y()) / normal.z();
}

Eigen::Vector2d ideal_of_pixel(const Camera& camera, const Eigen::Vector2d& pixel) {
  if (camera.projection == Camera::Projection::kPinhole) {
    return {(pixel.x() - camera.K(0, 2)) / camera.K(0, 0),
            (pixel.y() - camera.K(1, 2)) / camera.K(1, 1)};
  }
  return {(pixel.x() - camera.K(0, 2)) / camera.px_per_mm,
          (pixel.y() - camera.K(1, 2)) / camera.px_per_mm};
}

/// Calls visit(row, first column, last column) for the cells inside the loops.
template <typename Visit>
void scan(const std::vector<std::vector<Eigen::Vector2d>>& loops, int columns, int rows,
          std::vector<double>& cuts, Visit visit) {
  double low = 1e300, high = -1e300;
  for (const Eigen::Vector2d& x : loops.front()) {
    low = std::min(low, x.y());
    high = std::max(high, x.y());
  }
  const int first = std::max(0, static_cast<int>(std::ceil(std::max(low, -1.0))));
  const int last = std::min(rows - 1, static_cast<int>(std::floor(std::min(high, 1e6))));
  for (int row = first; row <= last; ++row) {
    cuts.clear();
    for (const auto& loop : loops) {
      Eigen::Vector2d q0 = loop.back();
      for (const Eigen::Vector2d& q1 : loop) {
        if ((q0.y() > row) != (q1.y() > row)) {
          cuts.push_back(q0.x() + (row - q0.y()) / (q1.y() - q0.y()) * (q1.x() - q0.x()));
        }
        q0 = q1;
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
      const int from = static_cast<int>(std::ceil(std::max(cuts[i], 0.0)));
      const int to = static_cast<int>(std::floor(std::min(cuts[i + 1], columns - 1.0)));
      if (from <= to) visit(row, from, to);
    }
  }
}

template <typename Visit>
void draw(const Camera& camera, const PlacedModel& placed, int columns, int rows, Visit visit) {
  const ProjectedModel projected = project_model(camera, placed);
  std::vector<Eigen::Vector2d> pixels;
  for (const Eigen::Vector3d& x : projected.x_in_camera) {
    pixels.push_back(camera.project_camera(x) / SurfaceMap::kCellPx);
  }
  std::vector<std::vector<Eigen::Vector2d>> loops;
  std::vector<double> cuts;
  for (int s = 0; s < static_cast<int>(projected.front.size()); ++s) {
    if (!projected.front[s]) continue;
    loops.clear();
    for (const std::vector<int>& loop : placed.model->surfaces[s].loops) {
      loops.emplace_back();
      for (int v : loop) loops.back().push_back(pixels[v]);
    }
    scan(loops, columns, rows, cuts, [&](int row, int from, int to) {
      for (int column = from; column <= to; ++column) {
        // Lens distortion moves a depth by far less than objects are apart.
        const Eigen::Vector2d ideal = ideal_of_pixel(
            camera, Eigen::Vector2d(column, row) * static_cast<double>(SurfaceMap::kCellPx));
        visit(s, row * columns + column,
              static_cast<float>(
                  plane_depth(camera, projected.normals[s], projected.offsets[s], ideal)));
      }
    });
  }
}

int cells(int px) { return (px + SurfaceMap::kCellPx - 1) / SurfaceMap::kCellPx; }

}  // namespace

std::int32_t SurfaceMap::at(double x_px, double y_px) const {
  const int column = static_cast<int>(std::lround(x_px / kCellPx));
  const int row = static_cast<int>(std::lround(y_px / kCellPx));
  if (column < 0 || row < 0 || column >= columns || row >= rows) return kNothing;
  return ids[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(column)];
}

SurfaceMap surface_map(const Camera& camera, const std::vector<PlacedModel>& objects) {
  SurfaceMap map;
  map.columns = cells(camera.width_px);
  map.rows = cells(camera.height_px);
  const auto count = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  map.ids.assign(count, SurfaceMap::kNothing);
  map.depths.assign(count, 1e30F);
  for (int object = 0; object < static_cast<int>(objects.size()); ++object) {
    draw(camera, objects[object], map.columns, map.rows, [&](int surface, int cell, float depth) {
      if (depth >= map.depths[cell]) return;
      map.depths[cell] = depth;
      map.ids[cell] = object * 1024 + surface;
    });
  }
  return map;
}

std::vector<SurfaceVisibility> surface_visibility(const Camera& camera,
                                                  const std::vector<PlacedModel>& objects,
                                                  int index) {
  std::vector<SurfaceVisibility> out(objects[index].model->surfaces.size());
  const SurfaceMap alone = surface_map(camera, {objects[index]});
  const SurfaceMap together = surface_map(camera, objects);
  for (std::size_t i = 0; i < alone.ids.size(); ++i) {
    if (alone.ids[i] == SurfaceMap::kNothing) continue;
    SurfaceVisibility& surface = out[SurfaceMap::surface_of(alone.ids[i])];
    ++surface.cells;
    if (SurfaceMap::object_of(together.ids[i]) == index && together.ids[i] >= 0) {
      ++surface.visible_cells;
    }
  }
  return out;
}

}  // namespace trihedron
