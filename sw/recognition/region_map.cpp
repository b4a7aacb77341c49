// SPDX-License-Identifier: Apache-2.0
#include "recognition/region_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
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

/// How far back the direction of a contour end is taken from: long enough that the staircase
/// of a digital line turns it by no more than atan(1/5).
constexpr int kDirectionPx = 5;

class Bitmap {
 public:
  Bitmap(std::vector<std::uint8_t>* bits, int width, int height)
      : bits_(*bits), width_(width), height_(height) {}
  bool get(Pixel p) const {
    return p.x >= 0 && p.y >= 0 && p.x < width_ && p.y < height_ && bits_[index(p)] != 0;
  }
  void set(Pixel p) { bits_[index(p)] = 1; }

 private:
  std::size_t index(Pixel p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(p.x);
  }
  std::vector<std::uint8_t>& bits_;
  int width_, height_;
};

/// A contour pixel is an end when its contour neighbours form one run of at most two pixels
/// around it.
bool is_end(const Bitmap& contour, Pixel p) {
  int count = 0, runs = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const bool here = contour.get({p.x + kAround[i].x, p.y + kAround[i].y});
    const Pixel before = kAround[(i + 7) % 8];
    count += here;
    runs += here && !contour.get({p.x + before.x, p.y + before.y});
  }
  return runs <= 1 && count <= 2;
}

/// The pixels of the branch that ends at `end`, from the end backwards.
std::vector<Pixel> walk_back(const Bitmap& contour, Pixel end) {
  std::vector<Pixel> path = {end};
  while (static_cast<int>(path.size()) <= kDirectionPx) {
    const Pixel p = path.back();
    bool moved = false;
    for (const Pixel& d : kAround) {
      const Pixel q = {p.x + d.x, p.y + d.y};
      const bool known =
          std::any_of(path.begin(), path.end(), [&](Pixel o) { return o.x == q.x && o.y == q.y; });
      if (known || !contour.get(q)) continue;
      path.push_back(q);
      moved = true;
      break;
    }
    if (!moved) break;
  }
  return path;
}

void draw_line(Bitmap* contour, Pixel a, Pixel b) {
  const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
  for (int i = 1; i < steps; ++i) {
    contour->set({a.x + static_cast<int>(std::lround(double(b.x - a.x) * i / steps)),
                  a.y + static_cast<int>(std::lround(double(b.y - a.y) * i / steps))});
  }
}

/// Joins the end to the nearest contour pixel within 60 degrees of straight on.
void bridge_end(const Bitmap& contour, Bitmap* bridged, Pixel end, int bridge_px) {
  const std::vector<Pixel> path = walk_back(contour, end);
  const int reach = bridge_px + 1;
  const double dx = end.x - path.back().x, dy = end.y - path.back().y;
  const double length = std::hypot(dx, dy);
  Pixel best = end;
  double best_distance = reach + 0.5;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Pixel q = {end.x + x, end.y + y};
      const double distance = std::hypot(x, y);
      if (distance < 1.5 || distance >= best_distance || !contour.get(q)) continue;
      if (x * dx + y * dy < 0.5 * distance * length) continue;
      best = q;
      best_distance = distance;
    }
  }
  draw_line(bridged, end, best);
}

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

void flood_background(RegionMap* map) {
  const auto start = [map](int x, int y) {
    if (map->at(x, y) == kUnlabelled) flood(map, {x, y}, RegionMap::kBackground);
  };
  for (int x = 0; x < map->width; ++x) start(x, 0), start(x, map->height - 1);
  for (int y = 0; y < map->height; ++y) start(0, y), start(map->width - 1, y);
}

}  // namespace

std::vector<std::uint8_t> bridged_contour(const ViewFeatures& features, int bridge_px) {
  std::vector<std::uint8_t> bits(features.contour.size());
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = features.contour[i].contour();
  std::vector<std::uint8_t> bridged = bits;
  const Bitmap contour(&bits, features.width, features.height);
  Bitmap target(&bridged, features.width, features.height);
  for (int y = 0; y < features.height; ++y) {
    for (int x = 0; x < features.width; ++x) {
      if (contour.get({x, y}) && is_end(contour, {x, y})) {
        bridge_end(contour, &target, {x, y}, bridge_px);
      }
    }
  }
  return bridged;
}

RegionMap label_regions(const std::vector<std::uint8_t>& contour, int width, int height,
                        int min_region_px) {
  RegionMap map{width, height, 0, std::vector<int>(contour.size())};
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
  return map;
}

}  // namespace trihedron
