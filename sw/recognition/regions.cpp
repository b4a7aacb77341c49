// SPDX-License-Identifier: Apache-2.0
#include "recognition/regions.hpp"

#include <cmath>
#include <utility>

#include "recognition/contour_linking.hpp"
#include "recognition/region_boundary.hpp"
#include "recognition/region_map.hpp"
#include "recognition/region_polygon.hpp"

namespace trihedron {
namespace {

Region make_region(const std::vector<BoundaryLoop>& loops,
                   const std::vector<Eigen::Vector2d>& proposals) {
  Region region;
  for (const BoundaryLoop& loop : loops) {
    ImagePolygon polygon = fit_polygon(loop.points, proposals);
    if (polygon.empty()) continue;
    region.area_px2 -= signed_area(polygon);
    if (loop.outer) {
      region.outer = std::move(polygon);
    } else {
      region.holes.push_back(std::move(polygon));
    }
  }
  return region;
}

}  // namespace

std::vector<Region> find_regions(const ViewFeatures& features, const RegionOptions& options) {
  const RegionMap map =
      label_regions(linked_contour(features, options.bridge_px), features, options.min_region_px);
  std::vector<Eigen::Vector2d> proposals;
  for (const Vertex& v : features.vertices) proposals.emplace_back(v.x, v.y);
  const std::vector<std::vector<BoundaryLoop>> boundaries = trace_boundaries(map, features);
  std::vector<Region> regions;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    Region region = make_region(boundaries[i], proposals);
    region.loose_px = map.loose_px[i];
    if (!region.outer.empty()) regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace trihedron
