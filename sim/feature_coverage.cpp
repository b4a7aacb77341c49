// SPDX-License-Identifier: Apache-2.0
// The part of the functional coverage that looks at what came out.
#include <array>
#include <cstdlib>

#include "golden/gradient.hpp"
#include "sim/functional_coverage.hpp"

namespace trihedron::sim {
namespace {

constexpr int kLargeSlope = 40 * kGradientScale;  // of at most 96 grey levels per px
constexpr std::array<const char*, 5> kSlopes = {"-large", "-small", "0", "+small", "+large"};
constexpr std::array<const char*, 4> kFlags = {"none", "second only", "first only", "both"};
constexpr std::array<const char*, 5> kMagnitudes = {"0", "below noise floor", "lower half",
                                                    "upper half", "saturated"};
constexpr std::array<const char*, 5> kEnds = {"clean", "bad line", "bad height", "too few rows",
                                              "vertices lost"};

std::size_t slope_class(int slope) {
  const int step = slope == 0 ? 0 : std::abs(slope) >= kLargeSlope ? 2 : 1;
  return static_cast<std::size_t>(slope < 0 ? 2 - step : 2 + step);
}

std::size_t magnitude_class(int magnitude) {
  if (magnitude == 0) return 0;
  if (magnitude < golden::FirstContourConfig{}.noise_floor) return 1;
  if (magnitude == golden::kMaxMagnitude) return 4;
  return magnitude < golden::kMaxMagnitude / 2 ? 2 : 3;
}

}  // namespace

void FunctionalCoverage::sample(const FrameResult& frame) {
  const std::string view = " | view " + std::to_string(frame.view);
  if (frame.status == 0) add("frame end x view", kEnds[0] + view);
  for (std::size_t bit = 0; bit + 1 < kEnds.size(); ++bit) {
    if ((frame.status >> bit) & 1) add("frame end x view", kEnds[bit + 1] + view);
  }
  std::array<std::uint64_t, 4> flags{};
  std::array<std::uint64_t, 5> magnitudes{};
  std::array<std::array<std::uint64_t, 5>, 5> slopes{};
  for (const ContourBeat& beat : frame.features.contour) {
    ++flags[beat.flags & 3u];
    ++magnitudes[magnitude_class(beat.magnitude)];
    ++slopes[slope_class(beat.gx)][slope_class(beat.gy)];
  }
  for (std::size_t i = 0; i < flags.size(); ++i) add("contour flags", kFlags[i], flags[i]);
  for (std::size_t i = 0; i < kMagnitudes.size(); ++i) {
    add("magnitude", kMagnitudes[i], magnitudes[i]);
    for (std::size_t j = 0; j < kSlopes.size(); ++j) {
      add("gx x gy", std::string(kSlopes[i]) + " | " + kSlopes[j], slopes[i][j]);
    }
  }
  for (const Vertex& vertex : frame.features.vertices) {
    add("vertex branches", std::to_string(vertex.branches));
    add("vertex strength", vertex.strength <= 35   ? "25 .. 35"
                           : vertex.strength <= 49 ? "36 .. 49"
                                                   : "50 .. 64");
    add("vertex pattern: first branch", std::to_string(vertex.pattern / 16));
    add("vertex pattern: last branch", std::to_string(vertex.pattern % 16));
  }
}

}  // namespace trihedron::sim
