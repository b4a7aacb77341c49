// SPDX-License-Identifier: Apache-2.0
#include "recognition/clear_contour.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "golden/front_end.hpp"
#include "recognition/edgels.hpp"

using namespace trihedron;

namespace {

constexpr int kSize = 200, kEdge = 100;  // px; the image, and the column of its one edge

/// A step of `height` grey levels at kEdge, with Gaussian noise.
ViewFeatures step_features(double height, double noise) {
  std::mt19937 random(11);
  std::normal_distribution<double> gauss(0, 1);
  std::vector<std::uint8_t> grey;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double value = 100 + (x < kEdge ? 0 : height) + noise * gauss(random);
      grey.push_back(static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)));
    }
  }
  return golden::run_front_end(grey.data(), kSize, kSize, kSize);
}

struct Shares {
  double of_edge = 0;    ///< rows with a pixel on the edge
  double elsewhere = 0;  ///< pixels further from it than the masks reach
};

template <typename IsContour>
Shares shares(IsContour is_contour) {
  constexpr int kReachPx = 8, kBorderPx = 6;
  Shares out;
  int rows = 0, others = 0;
  for (int y = kBorderPx; y < kSize - kBorderPx; ++y) {
    ++rows;
    out.of_edge += is_contour(kEdge - 2, y) || is_contour(kEdge - 1, y) || is_contour(kEdge, y) ||
                   is_contour(kEdge + 1, y);
    for (int x = kBorderPx; x < kSize - kBorderPx; ++x) {
      if (std::abs(x - kEdge) <= kReachPx) continue;
      ++others;
      out.elsewhere += is_contour(x, y);
    }
  }
  return {out.of_edge / rows, out.elsewhere / others};
}

Shares hardware_shares(const ViewFeatures& features) {
  return shares([&](int x, int y) { return features.at(x, y).contour(); });
}

Shares clear_shares(const ViewFeatures& features) {
  std::vector<char> mask(features.contour.size(), 0);
  for (const ContourPixel& p : clear_contour(features, find_edgels(features).noise)) {
    mask[static_cast<std::size_t>(p.y) * kSize + static_cast<std::size_t>(p.x)] = 1;
  }
  return shares([&](int x, int y) {
    return mask[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)] != 0;
  });
}

}  // namespace

TEST_CASE("noise that passes the hardware's threshold is no clear contour, the edge stays") {
  const ViewFeatures features = step_features(60, 12);
  const Shares all = hardware_shares(features), clear = clear_shares(features);
  CHECK(all.elsewhere > 0.1);         // else the test shows nothing
  CHECK(clear.elsewhere < 1 / 90.0);  // the tail of the Rayleigh distribution above 3 sigma
  CHECK(clear.of_edge > 0.95);
}

TEST_CASE("a clean image's clear contour is the hardware's, in raster order") {
  const ViewFeatures features = step_features(60, 0);
  const std::vector<ContourPixel> clear = clear_contour(features, find_edgels(features).noise);
  std::vector<ContourPixel> stream;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (!features.at(x, y).contour()) continue;
      stream.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)});
    }
  }
  REQUIRE_FALSE(stream.empty());
  CHECK(std::equal(
      clear.begin(), clear.end(), stream.begin(), stream.end(),
      [](const ContourPixel& a, const ContourPixel& b) { return a.x == b.x && a.y == b.y; }));
}
