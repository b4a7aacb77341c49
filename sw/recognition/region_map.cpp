// SPDX-License-Identifier: Apache-2.0
#include "recognition/region_map.hpp"

#include <algorithm>
#include <array>
#include <deque>

namespace trihedron {
namespace {

struct Pixel {
  int x, y;
};

constexpr std::array<Pixel, 4> kAcross = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
constexpr std::array<Pixel, 8> kAround = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

constexpr int kUnlabelled = -2;

/// Fills the component of `from` with `label`; returns its pixels.
std::vector<Pixel> flood(RegionMap* map, Pixel from, int label) {
  const auto cell = [map](Pixel p) -> int& {
    return map->labels[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(map->width) +
                       static_cast<std::size_t>(p.x)];
  };
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

/// Gives contour pixels that touch one region only to that region, until none is left.
void absorb(RegionMap* map) {
  std::deque<Pixel> queue;
  for (int y = 0; y < map->height; ++y) {
    for (int x = 0; x < map->width; ++x) {
      if (map->at(x, y) == RegionMap::kContour) queue.push_back({x, y});
    }
  }
  while (!queue.empty()) {
    const Pixel p = queue.front();
    queue.pop_front();
    if (map->at(p.x, p.y) != RegionMap::kContour) continue;
    const int label = only_label_around(*map, p);
    if (label == RegionMap::kContour) continue;
    map->labels[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(map->width) +
                static_cast<std::size_t>(p.x)] = label;
    for (const Pixel& d : kAround) {
      const Pixel q = {p.x + d.x, p.y + d.y};
      if (map->inside(q.x, q.y) && map->at(q.x, q.y) == RegionMap::kContour) queue.push_back(q);
    }
  }
}

/// Contour pixels inside each region that do not touch the contours around it.
std::vector<int> count_loose(const std::vector<std::uint8_t>& contour, const RegionMap& map) {
  std::vector<int> loose(static_cast<std::size_t>(map.regions), 0);
  for (int y = 1; y + 1 < map.height; ++y) {
    for (int x = 1; x + 1 < map.width; ++x) {
      const int label = map.at(x, y);
      if (label <= 0 || !contour[static_cast<std::size_t>(y * map.width + x)]) continue;
      const bool touches = std::any_of(kAround.begin(), kAround.end(), [&](Pixel d) {
        return map.at(x + d.x, y + d.y) == RegionMap::kContour;
      });
      loose[static_cast<std::size_t>(label - 1)] += !touches;
    }
  }
  return loose;
}

void flood_background(RegionMap* map) {
  const auto start = [map](int x, int y) {
    if (map->at(x, y) == kUnlabelled) flood(map, {x, y}, RegionMap::kBackground);
  };
  for (int x = 0; x < map->width; ++x) start(x, 0), start(x, map->height - 1);
  for (int y = 0; y < map->height; ++y) start(0, y), start(map->width - 1, y);
}

}  // namespace

RegionMap label_regions(const std::vector<std::uint8_t>& contour, int width, int height,
                        int min_region_px) {
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
      if (static_cast<int>(pixels.size()) >= min_region_px) {
        ++map.regions;
        continue;
      }
      for (const Pixel& p : pixels) {
        map.labels[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(p.x)] = RegionMap::kContour;
      }
    }
  }
  absorb(&map);
  map.loose_px = count_loose(contour, map);
  return map;
}

}  // namespace trihedron
