// SPDX-License-Identifier: Apache-2.0
#include "golden/vertices.hpp"

#include <algorithm>
#include <cstdlib>

namespace trihedron::golden {
namespace {

/// Contour runs on the ring of 16 pixels around the 5x5 window: the branches that leave it.
int count_branches(const Plane<std::uint8_t>& contour, int x, int y) {
  constexpr int kRing[16][2] = {{2, 0},  {2, 1},  {2, 2},  {1, 2},   {0, 2},   {-1, 2},
                                {-2, 2}, {-2, 1}, {-2, 0}, {-2, -1}, {-2, -2}, {-1, -2},
                                {0, -2}, {1, -2}, {2, -2}, {2, -1}};
  int runs = 0;
  int previous = contour.at(x + kRing[15][0], y + kRing[15][1]);
  for (const auto& [i, j] : kRing) {
    const int now = contour.at(x + i, y + j);
    runs += now & ~previous & 1;
    previous = now;
  }
  return runs;
}

/// Largest turn of the gradient against the centre's over the window's contour pixels, as 64 times
/// the sine.
int curvature(const GradientImage& g, const Plane<std::uint8_t>& contour, int x, int y) {
  const int cx = g.gx.at(x, y);
  const int cy = g.gy.at(x, y);
  int best = 0;
  for (int j = -kWindowRadius; j <= kWindowRadius; ++j) {
    for (int i = -kWindowRadius; i <= kWindowRadius; ++i) {
      if (contour.at(x + i, y + j) == 0) continue;
      const int nx = g.gx.at(x + i, y + j);
      const int ny = g.gy.at(x + i, y + j);
      const int norm = std::max(std::abs(cx), std::abs(cy)) * std::max(std::abs(nx), std::abs(ny));
      best = std::max(best, norm ? 64 * std::abs(cx * ny - cy * nx) / norm : 0);
    }
  }
  return best;
}

}  // namespace

std::vector<Vertex> vertices(const GradientImage& gradient,
                             const Plane<std::uint8_t>& second_contour,
                             const VertexConfig& config) {
  const int width = second_contour.width;
  const int height = second_contour.height;
  Plane<std::uint16_t> strength(width, height);
  for (int y = kWindowRadius; y < height - kWindowRadius; ++y) {
    for (int x = kWindowRadius; x < width - kWindowRadius; ++x) {
      if (second_contour.at(x, y) == 0) continue;
      const int value = curvature(gradient, second_contour, x, y);
      strength.at(x, y) = static_cast<std::uint16_t>(value >= config.min_strength ? value : 0);
    }
  }
  std::vector<Vertex> found;
  for (int y = kWindowRadius; y < height - kWindowRadius; ++y) {
    for (int x = kWindowRadius; x < width - kWindowRadius; ++x) {
      const int centre = strength.at(x, y);
      if (centre == 0) continue;
      bool strongest = true;
      for (int j = -kWindowRadius; j <= kWindowRadius; ++j) {
        for (int i = -kWindowRadius; i <= kWindowRadius; ++i) {
          const int other = strength.at(x + i, y + j);
          const bool before = j < 0 || (j == 0 && i < 0);
          strongest = strongest && (before ? centre > other : centre >= other);
        }
      }
      if (!strongest) continue;
      Vertex vertex;
      vertex.x = static_cast<std::uint16_t>(x);
      vertex.y = static_cast<std::uint16_t>(y);
      vertex.branches = static_cast<std::uint8_t>(count_branches(second_contour, x, y));
      vertex.strength = static_cast<std::uint16_t>(centre);
      found.push_back(vertex);
    }
  }
  return found;
}

}  // namespace trihedron::golden
