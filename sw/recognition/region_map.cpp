// SPDX-License-Identifier: Apache-2.0
#include "recognition/region_map.hpp"

#include <algorithm>
#include <array>
#include <queue>

namespace trihedron {
namespace {

struct Pixel {
  int x, y;
};

constexpr std::array<Pixel, 4> kAcross = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
constexpr std::array<Pixel, 8> kAround = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

constexpr int kUnlabelled = -2;
/// Mean width of the narrowest region: two contours that leave fewer pixels between them lie in
/// one another's 5x5 windows.
constexpr int kMinWidthPx = 2;

/// Fills the component of `from` with `label`; returns its pixels.
std::vector<Pixel> flood(RegionMap* map, Pixel from, int label) {
  const auto cell = [map](Pixel p) -> int& { return map->labels[map->index(p.x, p.y)]; };
  std::vector<Pixel> pixels = {from};
  cell(from) = label;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (const Pixel& d : kAcross) {
      const Pixel q = {pixels[i].x + d.x, pixels[i].y + d.y};
      if (!map->inside(q.x, q.y) || cell(q) != kUnlabelled) continue;
      cell(q) = label;
      pixels.push_back(q);
    }
  }
  return pixels;
}

/// The one label around a contour pixel, or kContour when there are none or several.
int only_label_around(const RegionMap& map, Pixel p) {
  int only = RegionMap::kContour;
  for (const Pixel& d : kAround) {
    const Pixel q = {p.x + d.x, p.y + d.y};
    const int label = map.inside(q.x, q.y) ? map.at(q.x, q.y) : RegionMap::kBackground;
    if (label == RegionMap::kContour) continue;
    if (only != RegionMap::kContour && only != label) return RegionMap::kContour;
    only = label;
  }
  return only;
}

/// Gives contour pixels that touch one region only to that region until none is left, the weakest
/// first: what remains runs along the ridge of the gradient.
void absorb(const ViewFeatures& features, RegionMap* map) {
  struct Entry {
    int magnitude;
    Pixel at;
    bool operator<(const Entry& o) const {  // weakest on top, then raster order
      if (magnitude != o.magnitude) return magnitude > o.magnitude;
      return at.y != o.at.y ? at.y > o.at.y : at.x > o.at.x;
    }
  };
  std::priority_queue<Entry> queue;
  const auto offer = [&](int x, int y) {
    if (!map->inside(x, y) || map->at(x, y) != RegionMap::kContour) return;
    if (only_label_around(*map, {x, y}) == RegionMap::kContour) return;
    queue.push({features.at(x, y).magnitude, {x, y}});
  };
  for (int y = 0; y < map->height; ++y) {
    for (int x = 0; x < map->width; ++x) offer(x, y);
  }
  while (!queue.empty()) {
    const Pixel p = queue.top().at;
    queue.pop();
    if (map->at(p.x, p.y) != RegionMap::kContour) continue;
    const int label = only_label_around(*map, p);
    if (label == RegionMap::kContour) continue;
    map->labels[map->index(p.x, p.y)] = label;
    for (const Pixel& d : kAround) offer(p.x + d.x, p.y + d.y);
  }
}

/// Contour pixels inside each region farther than a window of the front end from the contours
/// around it.
std::vector<int> count_loose(const std::vector<std::uint8_t>& contour, const RegionMap& map) {
  constexpr int kReach = 4;
  std::vector<int> loose(static_cast<std::size_t>(map.regions), 0);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const int label = map.at(x, y);
      if (label <= 0 || !contour[map.index(x, y)]) continue;
      bool near = false;
      for (int j = -kReach; j <= kReach && !near; ++j) {
        for (int i = -kReach; i <= kReach && !near; ++i) {
          near = map.inside(x + i, y + j) && map.at(x + i, y + j) == RegionMap::kContour;
        }
      }
      loose[static_cast<std::size_t>(label - 1)] += !near;
    }
  }
  return loose;
}

/// Too small or too narrow for two contours to be told apart.
bool is_flaw(const std::vector<Pixel>& pixels, int min_region_px) {
  int left = pixels[0].x, right = left, top = pixels[0].y, bottom = top;
  for (const Pixel& p : pixels) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  const int extent = std::max(right - left, bottom - top) + 1;
  const int area = static_cast<int>(pixels.size());
  return area < min_region_px || area < kMinWidthPx * extent;
}

void flood_background(RegionMap* map) {
  const auto start = [map](int x, int y) {
    if (map->at(x, y) == kUnlabelled) flood(map, {x, y}, RegionMap::kBackground);
  };
  for (int x = 0; x < map->width; ++x) start(x, 0), start(x, map->height - 1);
  for (int y = 0; y < map->height; ++y) start(0, y), start(map->width - 1, y);
}

}  // namespace

RegionMap label_regions(const std::vector<std::uint8_t>& contour, const ViewFeatures& features,
                        int min_region_px) {
  const int width = features.width, height = features.height;
  RegionMap map{width, height, 0, {}, std::vector<int>(contour.size())};
  for (std::size_t i = 0; i < contour.size(); ++i) {
    map.labels[i] = contour[i] ? RegionMap::kContour : kUnlabelled;
  }
  if (map.labels.empty()) return map;
  flood_background(&map);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (map.at(x, y) != kUnlabelled) continue;
      const std::vector<Pixel> pixels = flood(&map, {x, y}, map.regions + 1);
      if (!is_flaw(pixels, min_region_px)) {
        ++map.regions;
        continue;
      }
      for (const Pixel& p : pixels) map.labels[map.index(p.x, p.y)] = RegionMap::kContour;
    }
  }
  absorb(features, &map);
  map.loose_px = count_loose(contour, map);
  return map;
}

}  // namespace trihedron
