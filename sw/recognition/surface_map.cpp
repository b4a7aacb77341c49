// SPDX-License-Identifier: Apache-2.0
// Draws placed models into a coarse map of surfaces: for areas (what is visible of a surface,
// whose pixel is it), not for edges, which are exact in visibility.cpp.
#include <algorithm>
#include <cmath>

#include "recognition/projected_model.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {
namespace {

/// Depth of a surface's plane at the cells of the image: (p + q . cell) / (r + s . cell). Lens
/// distortion moves a depth by far less than objects are apart.
struct PlaneDepth {
  PlaneDepth(const Camera& camera, const Eigen::Vector3d& normal, double offset) {
    const bool pinhole = camera.projection == Camera::Projection::kPinhole;
    const Eigen::Vector2d focal = pinhole ? Eigen::Vector2d(camera.K(0, 0), camera.K(1, 1))
                                          : Eigen::Vector2d::Constant(camera.px_per_mm);
    const Eigen::Vector2d per_cell =
        SurfaceMap::kCellPx * (normal.head<2>().array() / focal.array()).matrix();
    const Eigen::Vector2d middle(camera.K(0, 2), camera.K(1, 2));
    const double at_corner = -(normal.head<2>().array() * middle.array() / focal.array()).sum();
    p = pinhole ? offset : offset - at_corner;
    r = pinhole ? normal.z() + at_corner : normal.z();
    (pinhole ? s : q) = pinhole ? per_cell : Eigen::Vector2d(-per_cell);
  }

  double p, r;
  Eigen::Vector2d q = Eigen::Vector2d::Zero(), s = q;
};

/// A rectangle of cells of the image.
struct Window {
  int column, row, columns, rows;
};

/// Calls visit(row, first column, last column) for the window's cells inside the loops.
template <typename Visit>
void scan(const std::vector<std::vector<Eigen::Vector2d>>& loops, const Window& window,
          std::vector<double>& cuts, Visit visit) {
  const double left = window.column, right = left + window.columns - 1;
  double low = 1e300, high = -1e300;
  for (const Eigen::Vector2d& x : loops.front()) {
    low = std::min(low, x.y());
    high = std::max(high, x.y());
  }
  const int first = std::max(window.row, static_cast<int>(std::ceil(std::max(low, -1.0))));
  const int last =
      std::min(window.row + window.rows - 1, static_cast<int>(std::floor(std::min(high, 1e6))));
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
      const int from = static_cast<int>(std::ceil(std::max(cuts[i], left)));
      const int to = static_cast<int>(std::floor(std::min(cuts[i + 1], right)));
      if (from <= to) visit(row, from, to);
    }
  }
}

/// A placed model in the image, in cells.
struct Drawing {
  Drawing(const Camera& camera, const PlacedModel& placed)
      : projected(project_model(camera, placed)) {
    for (const Eigen::Vector3d& x : projected.x_in_camera) {
      cells.push_back(camera.project_camera(x) / SurfaceMap::kCellPx);
    }
  }

  /// The part of `image` that the model covers.
  Window window(const Window& image) const {
    const auto& front = projected.front;
    if (std::none_of(front.begin(), front.end(), [](char f) { return f; })) return {0, 0, 0, 0};
    const Eigen::Array2d end(image.columns, image.rows);
    Eigen::Array2d low = end, high = Eigen::Array2d::Zero();
    for (const Eigen::Vector2d& x : cells) {
      low = low.min(x.array().floor());
      high = high.max(x.array().ceil() + 1);
    }
    const Eigen::Array2i from = low.max(0).cast<int>();
    const Eigen::Array2i count = (high.min(end).cast<int>() - from).max(0);
    return {from.x(), from.y(), count.x(), count.y()};
  }

  ProjectedModel projected;
  std::vector<Eigen::Vector2d> cells;  // vertices
};

/// Calls visit(surface, index of the cell in the window, depth).
template <typename Visit>
void draw(const Camera& camera, const Drawing& drawing, const Window& window, Visit visit) {
  const ProjectedModel& projected = drawing.projected;
  std::vector<std::vector<Eigen::Vector2d>> loops;
  std::vector<double> cuts;
  for (int s = 0; s < static_cast<int>(projected.front.size()); ++s) {
    if (!projected.front[s]) continue;
    loops.clear();
    for (const std::vector<int>& loop : projected.model->surfaces[s].loops) {
      loops.emplace_back();
      for (int v : loop) loops.back().push_back(drawing.cells[v]);
    }
    const PlaneDepth plane(camera, projected.normals[s], projected.offsets[s]);
    const auto q = static_cast<float>(plane.q.x()), r = static_cast<float>(plane.s.x());
    scan(loops, window, cuts, [&](int row, int from, int to) {
      const int start = (row - window.row) * window.columns - window.column;
      const auto above = static_cast<float>(plane.p + plane.q.y() * row);
      const auto below = static_cast<float>(plane.r + plane.s.y() * row);
      for (int column = from; column <= to; ++column) {
        const auto c = static_cast<float>(column);
        visit(s, start + column, (above + q * c) / (below + r * c));
      }
    });
  }
}

int cells(int px) { return (px + SurfaceMap::kCellPx - 1) / SurfaceMap::kCellPx; }

Window image_of(const Camera& camera) {
  return {0, 0, cells(camera.width_px), cells(camera.height_px)};
}

/// The cells of a window; positions in the map count from its corner.
SurfaceMap surface_map(const Camera& camera, const std::vector<PlacedModel>& objects,
                       const Window& window) {
  SurfaceMap map;
  map.columns = window.columns;
  map.rows = window.rows;
  const auto count = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  map.ids.assign(count, SurfaceMap::kNothing);
  map.depths.assign(count, 1e30F);
  for (int object = 0; object < static_cast<int>(objects.size()); ++object) {
    const Drawing drawing(camera, objects[object]);
    draw(camera, drawing, window, [&](int surface, int cell, float depth) {
      if (depth >= map.depths[cell]) return;
      map.depths[cell] = depth;
      map.ids[cell] = object * 1024 + surface;
    });
  }
  return map;
}

}  // namespace

std::int32_t SurfaceMap::at(double x_px, double y_px) const {
  const int column = static_cast<int>(std::lround(x_px / kCellPx));
  const int row = static_cast<int>(std::lround(y_px / kCellPx));
  if (column < 0 || row < 0 || column >= columns || row >= rows) return kNothing;
  return ids[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(column)];
}

SurfaceMap surface_map(const Camera& camera, const std::vector<PlacedModel>& objects) {
  return surface_map(camera, objects, image_of(camera));
}

std::vector<SurfaceVisibility> surface_visibility(const Camera& camera,
                                                  const std::vector<PlacedModel>& objects,
                                                  int index) {
  std::vector<SurfaceVisibility> out(objects[index].model->surfaces.size());
  const Window window = Drawing(camera, objects[index]).window(image_of(camera));
  const SurfaceMap alone = surface_map(camera, {objects[index]}, window);
  const SurfaceMap together = surface_map(camera, objects, window);
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
