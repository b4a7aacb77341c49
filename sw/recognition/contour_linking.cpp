// SPDX-License-Identifier: Apache-2.0
#include "recognition/contour_linking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "recognition/weak_ridges.hpp"

namespace trihedron {
namespace {

struct Pixel {
  int x, y;
  bool operator==(const Pixel& o) const { return x == o.x && y == o.y; }
};
using Path = std::vector<Pixel>;

constexpr std::array<Pixel, 8> kAround = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// How far back the direction of a contour end is taken from: long enough that the staircase
/// of a digital line turns it by no more than atan(1/5).
constexpr int kDirectionPx = 5;
/// The ridge goes on while it is at least this part of what it was where the contour ended: the
/// usual ratio of the thresholds of a hysteresis.
constexpr double kRidgeRatio = 0.5;
/// And while it keeps its direction, cos 45 deg per step of one pixel.
constexpr double kStraightOn = 0.7;

struct Vec {
  double x, y;
};

double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
Vec unit(Vec v) {
  const double length = std::hypot(v.x, v.y);
  return length > 0 ? Vec{v.x / length, v.y / length} : Vec{0, 0};
}

class Linker {
 public:
  Linker(const ViewFeatures& features, int bridge_px)
      : features_(features), bridge_px_(bridge_px), linked_(features.contour.size()) {
    for (std::size_t i = 0; i < linked_.size(); ++i) linked_[i] = features.contour[i].contour();
    add_weak_ridges(features, &linked_);
    drop_specks();
  }

  std::vector<std::uint8_t> run() {
    Path ends;
    for (int y = 0; y < features_.height; ++y) {
      for (int x = 0; x < features_.width; ++x) {
        if (contour({x, y}) && is_end({x, y})) ends.push_back({x, y});
      }
    }
    for (const Pixel& end : ends) link(end);
    return linked_;
  }

 private:
  bool inside(Pixel p) const {
    return p.x >= 0 && p.y >= 0 && p.x < features_.width && p.y < features_.height;
  }
  std::size_t index(Pixel p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(features_.width) +
           static_cast<std::size_t>(p.x);
  }
  bool contour(Pixel p) const { return inside(p) && linked_[index(p)] != 0; }

  /// Fragments too short to have a direction have no ends to go on from; a ridge that crosses
  /// them must not end there.
  void drop_specks() {
    std::vector<std::uint8_t> seen(linked_.size(), 0);
    for (int y = 0; y < features_.height; ++y) {
      for (int x = 0; x < features_.width; ++x) {
        if (!contour({x, y}) || seen[index({x, y})]) continue;
        const Path fragment = flood({x, y}, &seen);
        if (static_cast<int>(fragment.size()) >= kDirectionPx) continue;
        for (const Pixel& p : fragment) linked_[index(p)] = 0;
      }
    }
  }

  Path flood(Pixel from, std::vector<std::uint8_t>* seen) const {
    Path pixels = {from};
    (*seen)[index(from)] = 1;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      for (const Pixel& d : kAround) {
        const Pixel q = {pixels[i].x + d.x, pixels[i].y + d.y};
        if (!contour(q) || (*seen)[index(q)]) continue;
        (*seen)[index(q)] = 1;
        pixels.push_back(q);
      }
    }
    return pixels;
  }

  /// Its contour neighbours form one run of at most two pixels around it.
  bool is_end(Pixel p) const {
    int count = 0, runs = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const Pixel before = kAround[(i + 7) % 8];
      const bool here = contour({p.x + kAround[i].x, p.y + kAround[i].y});
      count += here;
      runs += here && !contour({p.x + before.x, p.y + before.y});
    }
    return runs <= 1 && count <= 2;
  }

  /// The pixels of the branch that ends at `end`, from the end backwards.
  Path walk_back(Pixel end) const {
    Path path = {end};
    while (static_cast<int>(path.size()) <= kDirectionPx) {
      const Pixel p = path.back();
      const auto next = std::find_if(kAround.begin(), kAround.end(), [&](Pixel d) {
        const Pixel q = {p.x + d.x, p.y + d.y};
        return contour(q) && std::find(path.begin(), path.end(), q) == path.end();
      });
      if (next == kAround.end()) break;
      path.push_back({p.x + next->x, p.y + next->y});
    }
    return path;
  }

  void link(Pixel end) {
    const Path branch = walk_back(end);
    Vec heading = {double(end.x - branch.back().x), double(end.y - branch.back().y)};
    heading = unit(heading);
    int strength = features_.at(end.x, end.y).magnitude;  // the branch may start on a strong edge
    for (const Pixel& p : branch) {
      strength = std::min<int>(strength, features_.at(p.x, p.y).magnitude);
    }
    Path path = {end};
    while (true) {
      if (const auto target = straight_target(path, branch, heading)) {
        path.push_back(*target);
        return draw(path);
      }
      const auto next = ridge_step(path, heading, kRidgeRatio * strength);
      if (!next) return;
      path.push_back(*next);
      heading = turned(heading, *next);
    }
  }

  /// The contour pixel within bridge_px missing pixels and 60 degrees of straight on that is
  /// nearest, distances weighed by 1 / cos^2: the same line going on rather than its neighbour.
  std::optional<Pixel> straight_target(const Path& path, const Path& branch, Vec heading) const {
    const Pixel from = path.back();
    const int reach = bridge_px_ + 1;
    std::optional<Pixel> best;
    double least = std::numeric_limits<double>::infinity();
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const Pixel q = {from.x + x, from.y + y};
        const double distance = std::hypot(x, y), along = dot({double(x), double(y)}, heading);
        if (distance == 0 || distance > reach + 0.5 || along < 0.5 * distance) continue;
        if (!contour(q) || std::find(branch.begin(), branch.end(), q) != branch.end()) continue;
        const double cost = distance * distance * distance / (along * along);
        if (cost < least) least = cost, best = q;
      }
    }
    return best;
  }

  /// The strongest of the pixels ahead.
  std::optional<Pixel> ridge_step(const Path& path, Vec heading, double floor) const {
    const Pixel p = path.back();
    std::optional<Pixel> best;
    for (const Pixel& d : kAround) {
      const Pixel q = {p.x + d.x, p.y + d.y};
      if (dot(unit({double(d.x), double(d.y)}), heading) < kStraightOn || !inside(q)) continue;
      const ContourBeat& beat = features_.at(q.x, q.y);
      if (beat.magnitude < std::max(1.0, floor)) continue;
      const Vec gradient = unit({double(beat.gx), double(beat.gy)});
      if (std::abs(dot(gradient, heading)) > kStraightOn) continue;
      if (!best || beat.magnitude > features_.at(best->x, best->y).magnitude) best = q;
    }
    return best;
  }

  /// The heading drawn towards the edge's direction at `p`, by as much as one pixel in
  /// kDirectionPx weighs.
  Vec turned(Vec heading, Pixel p) const {
    const ContourBeat& beat = features_.at(p.x, p.y);
    Vec along = unit({-double(beat.gy), double(beat.gx)});
    if (dot(along, heading) < 0) along = {-along.x, -along.y};
    const double weight = 1.0 / kDirectionPx;
    return unit({heading.x + weight * along.x, heading.y + weight * along.y});
  }

  void draw(const Path& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Pixel a = path[i - 1], b = path[i];
      const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
      for (int s = 1; s <= steps; ++s) {
        const int x = a.x + static_cast<int>(std::lround(double(b.x - a.x) * s / steps));
        const int y = a.y + static_cast<int>(std::lround(double(b.y - a.y) * s / steps));
        linked_[index({x, y})] = 1;
      }
    }
  }

  const ViewFeatures& features_;
  int bridge_px_;
  std::vector<std::uint8_t> linked_;
};

}  // namespace

std::vector<std::uint8_t> linked_contour(const ViewFeatures& features, int bridge_px) {
  return Linker(features, bridge_px).run();
}

}  // namespace trihedron
