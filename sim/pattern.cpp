// SPDX-License-Identifier: Apache-2.0
#include "sim/pattern.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trihedron::sim {
namespace {

std::uint8_t clamp_grey(int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); }

/// Calls `shade(x, y)` for every pixel.
template <typename Shade>
GreyImage paint(int width, int height, Shade&& shade) {
  GreyImage image{width, height, {}};
  image.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.push_back(shade(x, y));
  }
  return image;
}

/// The half plane dx * x + dy * y <= offset, with integer coefficients: equal on every machine.
struct HalfPlane {
  int dx = 0, dy = 0, offset = 0;
  bool holds(int x, int y) const { return dx * x + dy * y <= offset; }
};

HalfPlane half_plane_around(int x, int y, int reach, Random& random) {
  HalfPlane side;
  do {
    side.dx = random.between(-16, 16);
    side.dy = random.between(-16, 16);
  } while (side.dx == 0 && side.dy == 0);
  side.offset = side.dx * x + side.dy * y + 16 * random.between(1, reach);
  return side;
}

struct Polygon {
  std::vector<HalfPlane> sides;
  int grey = 0;
  bool covers(int x, int y) const {
    return std::all_of(sides.begin(), sides.end(),
                       [=](const HalfPlane& side) { return side.holds(x, y); });
  }
};

GreyImage polygons(int width, int height, Random& random) {
  std::vector<Polygon> shapes(static_cast<std::size_t>(random.between(1, 5)));
  const int reach = std::max(2, std::min(width, height) / 4);
  for (Polygon& shape : shapes) {
    const int x = random.between(0, width - 1), y = random.between(0, height - 1);
    for (int side = random.between(3, 6); side > 0; --side) {
      shape.sides.push_back(half_plane_around(x, y, reach, random));
    }
    shape.grey = random.between(0, 255);
  }
  const int ground = random.between(0, 255);
  const int noise = random.between(0, 3);
  return paint(width, height, [&](int x, int y) {
    int grey = ground;
    for (const Polygon& shape : shapes) {
      if (shape.covers(x, y)) grey = shape.grey;
    }
    return clamp_grey(grey + random.between(-noise, noise));
  });
}

GreyImage step(int width, int height, Random& random) {
  const HalfPlane edge = half_plane_around(width / 2, height / 2, 2, random);
  const int dark = random.between(0, 255), bright = random.between(0, 255);
  return paint(width, height,
               [&](int x, int y) { return clamp_grey(edge.holds(x, y) ? dark : bright); });
}

GreyImage single_pixels(int width, int height, Random& random) {
  const int ground = random.between(0, 255);
  GreyImage image = paint(width, height, [&](int, int) { return clamp_grey(ground); });
  for (int dot = random.between(1, 12); dot > 0; --dot) {
    const int at = random.between(0, width * height - 1);
    image.pixels[static_cast<std::size_t>(at)] = random.chance(0.5) ? 255 : 0;
  }
  return image;
}

GreyImage crop(int width, int height, Random& random, const GreyImage& picture) {
  const int left = random.between(0, std::max(0, picture.width - width));
  const int top = random.between(0, std::max(0, picture.height - height));
  const auto mirror = [](int i, int size) {
    const int phase = i % (2 * size);
    return phase < size ? phase : 2 * size - 1 - phase;
  };
  return paint(width, height, [&](int x, int y) {
    const int column = mirror(left + x, picture.width);
    const int row = mirror(top + y, picture.height);
    return picture.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(column)];
  });
}

GreyImage ramp(int width, int height, Random& random) {
  const int dx = random.between(-64, 64), dy = random.between(-64, 64);
  const int base = random.between(0, 255);
  return paint(width, height, [&](int x, int y) {
    return clamp_grey(base + (dx * (x - width / 2) + dy * (y - height / 2)) / 16);
  });
}

GreyImage stripes(int width, int height, Random& random) {
  const int dx = random.between(-1, 1), dy = dx == 0 ? 1 : random.between(-1, 1);
  const int bar = random.between(1, 4), shift = 4 * (width + height);
  return paint(width, height, [&](int x, int y) {
    return clamp_grey((dx * x + dy * y + shift) / bar % 2 ? 255 : 0);
  });
}

/// Signs of the four derivative masks (golden/gradient.hpp); zeros are drawn at random.
using Signs = std::array<std::array<int, 5>, 5>;
constexpr Signs kAlongX = {{{-1, -1, 0, 1, 1},
                            {-1, -1, 0, 1, 1},
                            {-1, -1, 0, 1, 1},
                            {-1, -1, 0, 1, 1},
                            {-1, -1, 0, 1, 1}}};
constexpr Signs kDiagonal = {{{-1, -1, -1, -1, 0},
                              {-1, -1, -1, 0, 1},
                              {-1, -1, 0, 1, 1},
                              {-1, 0, 1, 1, 1},
                              {0, 1, 1, 1, 1}}};

// Windows of random mask, sign and place on a ground of one level or of noise.
GreyImage extremes(int width, int height, Random& random) {
  const int ground = random.between(0, 255);
  const bool noisy = random.chance(0.3);
  GreyImage image = paint(
      width, height, [&](int, int) { return clamp_grey(noisy ? random.between(0, 255) : ground); });
  for (int window = 1 + width * height / 60; window > 0; --window) {
    const Signs& signs = random.chance(0.5) ? kAlongX : kDiagonal;
    const bool turned = random.chance(0.5);
    const int sign = random.chance(0.5) ? 1 : -1;
    const int left = random.between(0, width - 5), top = random.between(0, height - 5);
    for (std::size_t y = 0; y < 5; ++y) {
      for (std::size_t x = 0; x < 5; ++x) {
        // Transposed along x becomes along y; the diagonal mirrored is the other diagonal.
        const int s = sign * (&signs == &kAlongX ? (turned ? signs[x][y] : signs[y][x])
                                                 : signs[y][turned ? 4 - x : x]);
        const auto at = (static_cast<std::size_t>(top) + y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(left) + x;
        image.pixels[at] = s == 0 ? clamp_grey(random.between(0, 255)) : s > 0 ? 255 : 0;
      }
    }
  }
  return image;
}

}  // namespace

GreyImage make_image(Pattern pattern, int width, int height, Random& random,
                     const std::vector<GreyImage>& pictures) {
  const int level = random.between(0, 255);
  switch (pattern) {
    case Pattern::kFlat:
      return paint(width, height, [&](int, int) { return clamp_grey(level); });
    case Pattern::kNoise:
      return paint(width, height, [&](int, int) { return clamp_grey(random.between(0, 255)); });
    case Pattern::kFaintNoise:
      return paint(width, height,
                   [&](int, int) { return clamp_grey(level + random.between(-4, 4)); });
    case Pattern::kSaturated:
      return paint(width, height, [&](int, int) { return clamp_grey(random.between(0, 1) * 255); });
    case Pattern::kStep:
      return step(width, height, random);
    case Pattern::kSinglePixels:
      return single_pixels(width, height, random);
    case Pattern::kRamp:
      return ramp(width, height, random);
    case Pattern::kStripes:
      return stripes(width, height, random);
    case Pattern::kPicture:
      if (pictures.empty()) break;
      return crop(width, height, random,
                  pictures[static_cast<std::size_t>(
                      random.between(0, static_cast<int>(pictures.size()) - 1))]);
    case Pattern::kExtremes:
      if (std::min(width, height) < kMinSizePx) break;
      return extremes(width, height, random);
    case Pattern::kPolygons:
      break;
  }
  return polygons(width, height, random);
}

}  // namespace trihedron::sim
