// SPDX-License-Identifier: Apache-2.0
#include "golden/front_end.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>

#include "golden/error.hpp"
#include "golden/vector_clones.hpp"
#include "golden/window_block.hpp"

namespace trihedron::golden {
namespace {

/// Rows that a stage's output lags behind the image's latest row: each window needs two more.
constexpr int kFirstLag = kWindowRadius;
constexpr int kRidgeLag = kFirstLag + kWindowRadius;
constexpr int kContourLag = kRidgeLag + kWindowRadius;
constexpr int kValueLag = kContourLag + kWindowRadius;
constexpr int kScoreLag = kValueLag + kWindowRadius;
constexpr int kVertexLag = kScoreLag + 1;  // 3x3 pixels
static_assert(kContourLag < kLineMemoryRows, "the gradient is kept until the contour is known");
static_assert(kVertexLag + kWindowRadius - kContourLag < kLineMemoryRows,
              "directions are kept until the vertices are known");

/// What lies between the stages.
struct LineMemories {
  GradientImage gradient;
  Plane<std::uint8_t> first, ridge, second, value;
  Plane<Direction> direction;
  Plane<std::uint16_t> score;

  LineMemories(int width, int height)
      : gradient{Plane<std::int16_t>::line_memories(width, height),
                 Plane<std::int16_t>::line_memories(width, height),
                 Plane<std::uint16_t>::line_memories(width, height)},
        first(Plane<std::uint8_t>::line_memories(width, height)),
        ridge(first),
        second(first),
        value(first),
        direction(first),
        score(gradient.magnitude) {}
};

/// The contour stream's row y. Each beat is put together in one 64-bit word, lowest address first,
/// which the compiler does for several beats side by side.
TRIHEDRON_VECTOR_CLONES
void beat_row(const LineMemories& lines, int y, std::vector<ContourBeat>& beats) {
  static_assert(sizeof(ContourBeat) == sizeof(std::uint64_t) && offsetof(ContourBeat, gy) == 2 &&
                offsetof(ContourBeat, magnitude) == 4 && offsetof(ContourBeat, flags) == 6);
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  const std::int16_t* gx = lines.gradient.gx.row(y);
  const std::int16_t* gy = lines.gradient.gy.row(y);
  const std::uint16_t* magnitude = lines.gradient.magnitude.row(y);
  const std::uint8_t* first = lines.first.row(y);
  const std::uint8_t* second = lines.second.row(y);
  const int width = lines.first.width;
  std::uint64_t words[kBlockPx];
  for (int x = 0; x < width; x += kBlockPx) {
    const int n = std::min(kBlockPx, width - x);
    for (int i = 0; i < n; ++i) {
      const auto flags =
          static_cast<std::uint8_t>(second[x + i] * kContour | first[x + i] * kFirstContour);
      words[i] = static_cast<std::uint16_t>(gx[x + i]) |
                 std::uint64_t{static_cast<std::uint16_t>(gy[x + i])} << 16 |
                 std::uint64_t{magnitude[x + i]} << 32 | std::uint64_t{flags} << 48;
    }
    std::memcpy(static_cast<void*>(&beats[static_cast<std::size_t>(x)]), words,
                static_cast<std::size_t>(n) * sizeof *words);
  }
}

}  // namespace

ViewFeatures run_front_end(const std::uint8_t* grey, int width, int height, int stride,
                           const FrontEndConfig& config) {
  if (width < kMinFrameSide || height < kMinFrameSide) {
    throw Error("image is " + std::to_string(width) + " x " + std::to_string(height) +
                " px, the front end needs at least " + std::to_string(kMinFrameSide) + " x " +
                std::to_string(kMinFrameSide));
  }
  ViewFeatures features;
  features.width = width;
  features.height = height;
  features.contour.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  LineMemories lines(width, height);
  std::vector<ContourBeat> beats(static_cast<std::size_t>(width));
  // The stages take turns row by row, as in the hardware: what one writes, the next finds in cache.
  for (int latest = 0; latest < height + kVertexLag; ++latest) {
    const auto in_frame = [&](int y) { return y >= 0 && y < height; };
    if (in_frame(latest)) gradient_row(grey, stride, latest, lines.gradient);
    if (const int y = latest - kFirstLag; in_frame(y)) {
      first_contour_row(lines.gradient.magnitude, config.first_contour, y, lines.first);
    }
    if (const int y = latest - kRidgeLag; in_frame(y)) {
      ridge_row(lines.gradient, lines.first, config.second_contour, y, lines.ridge);
    }
    if (const int y = latest - kContourLag; in_frame(y)) {
      link_row(lines.ridge, lines.gradient.magnitude, config.first_contour.noise_floor, y,
               lines.second);
      direction_row(lines.gradient, lines.second, config.vertices.branch_floor, y, lines.direction);
      beat_row(lines, y, beats);
      features.contour.insert(features.contour.end(), beats.begin(), beats.end());
    }
    if (const int y = latest - kValueLag; in_frame(y)) {
      value_row(lines.direction, config.vertices, y, lines.value);
    }
    if (const int y = latest - kScoreLag; in_frame(y)) score_row(lines.value, y, lines.score);
    if (const int y = latest - kVertexLag; in_frame(y)) {
      append_vertices(lines.direction, lines.score, y, features.vertices);
    }
  }
  return features;
}

}  // namespace trihedron::golden
