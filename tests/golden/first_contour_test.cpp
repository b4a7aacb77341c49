// SPDX-License-Identifier: Apache-2.0
#include "golden/first_contour.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "images.hpp"

namespace trihedron::golden {
namespace {

using Magnitudes = Plane<std::uint16_t>;

constexpr int kInner[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

/// The definition, pixel by pixel, from lists instead of sums.
bool by_definition(const Magnitudes& m, int x, int y, const FirstContourConfig& config) {
  if (x < 2 || y < 2 || x >= m.width - 2 || y >= m.height - 2) return false;
  const double centre = m.at(x, y);
  std::vector<double> not_above;
  for (int j = -2; j <= 2; ++j) {
    for (int i = -2; i <= 2; ++i) {
      if ((i != 0 || j != 0) && m.at(x + i, y + j) <= centre)
        not_above.push_back(m.at(x + i, y + j));
    }
  }
  double sum = 0;
  for (const double n : not_above) sum += n;
  const double limit = config.mean_limit * centre * static_cast<double>(not_above.size());
  bool path = false;
  for (const auto& p : kInner) {
    for (const auto& q : kInner) {
      const bool touch = std::abs(p[0] - q[0]) <= 1 && std::abs(p[1] - q[1]) <= 1;
      path = path || (!touch && m.at(x + p[0], y + p[1]) >= 0.75 * centre &&
                      m.at(x + q[0], y + q[1]) >= 0.75 * centre);
    }
  }
  return centre >= config.noise_floor && 32 * sum < limit && path;
}

/// A vertical ridge through column 2 of a 5x5 window.
Magnitudes ridge(std::uint16_t crest, std::uint16_t flank, std::uint16_t foot) {
  Magnitudes m(5, 5);
  for (int y = 0; y < 5; ++y) {
    m.at(2, y) = crest;
    m.at(1, y) = m.at(3, y) = flank;
    m.at(0, y) = m.at(4, y) = foot;
  }
  return m;
}

TEST_CASE("a ridge is first contour down to the noise floor") {
  // Neighbours: 4 of the crest, 10 of the flank, 10 of the foot.
  CHECK(first_contour(ridge(12, 8, 2), {}).at(2, 2) == 1);  // 32 * 148 = 4736 < 21 * 12 * 24 = 6048
  CHECK(first_contour(ridge(11, 8, 2), {}).at(2, 2) == 0);
  CHECK(first_contour(ridge(11, 8, 2), {11, 21}).at(2, 2) == 1);
}

TEST_CASE("the mean of the neighbours that are not above the centre decides") {
  // 32 * (4 * 96 + 10 * f + 10 * 30) against 21 * 96 * 24 = 48384: equality at f = 82.8.
  CHECK(first_contour(ridge(96, 82, 30), {}).at(2, 2) == 1);
  CHECK(first_contour(ridge(96, 83, 30), {}).at(2, 2) == 0);
  // Neighbours above the centre count neither in the sum nor in the number.
  Magnitudes flank = ridge(96, 82, 30);
  for (int y = 0; y < 5; ++y) flank.at(4, y) = flank.at(3, y) = 400;
  // 32 * (4 * 96 + 5 * 82 + 5 * 30) = 30208 against 21 * 96 * 14 = 28224.
  CHECK(first_contour(flank, {}).at(2, 2) == 0);
  CHECK(first_contour(flank, {12, 23}).at(2, 2) == 1);
}

TEST_CASE("a plateau and a pit are no first contour") {
  CHECK(first_contour(ridge(200, 200, 200), {1, 31}).at(2, 2) == 0);
  Magnitudes pit = ridge(200, 200, 200);
  pit.at(2, 2) = 100;
  CHECK(first_contour(pit, {1, 31}).at(2, 2) == 0);
}

TEST_CASE("the path masks are all 16 pairs of inner neighbours that do not touch") {
  int accepted = 0;
  int smallest_accepted = 0;
  for (int set = 0; set < 256; ++set) {
    Magnitudes m(5, 5);
    m.at(2, 2) = 100;
    for (int k = 0; k < 8; ++k) {
      m.at(2 + kInner[k][0], 2 + kInner[k][1]) = (set >> k & 1) ? 75 : 74;
    }
    const bool first = first_contour(m, {1, 31}).at(2, 2) != 0;
    REQUIRE(first == by_definition(m, 2, 2, {1, 31}));
    accepted += first;
    const int size = static_cast<int>(__builtin_popcount(static_cast<unsigned>(set)));
    smallest_accepted += first && size == 2;
    if (size < 2) REQUIRE_FALSE(first);
    if (size > 4) REQUIRE(first);
  }
  CHECK(smallest_accepted == 16);
  // All but: none, 8 singles, 12 touching pairs and the 4 corner triples.
  CHECK(accepted == 256 - 1 - 8 - 12 - 4);
}

TEST_CASE("random magnitudes give what the definition says, thresholds included") {
  std::mt19937 random(17);
  for (int round = 0; round < 40; ++round) {
    Magnitudes m(5 + static_cast<int>(random() % 20), 5 + static_cast<int>(random() % 20));
    // Few grey levels make ties; many make the sums wide.
    const unsigned levels = round % 2 ? 5 : kMaxMagnitude + 1;
    for (auto& sample : m.samples) sample = static_cast<std::uint16_t>(random() % levels);
    const FirstContourConfig config{static_cast<int>(1 + random() % (levels / 2)),
                                    static_cast<int>(1 + random() % 31)};
    const auto contour = first_contour(m, config);
    for (int y = 0; y < m.height; ++y) {
      for (int x = 0; x < m.width; ++x) {
        INFO("round " << round << " pixel " << x << ", " << y);
        REQUIRE(contour.at(x, y) == by_definition(m, x, y, config));
      }
    }
  }
}

TEST_CASE("mirroring and transposing the magnitude does the same to the first contour") {
  const Magnitudes m = test::gradient_of(test::noise(40, 30, 21)).magnitude;
  const FirstContourConfig config{12, 29};
  const auto contour = first_contour(m, config);
  CHECK(std::count(contour.samples.begin(), contour.samples.end(), 1) > 0);
  CHECK(test::mirrored(first_contour(test::mirrored(m), config)).samples == contour.samples);
  CHECK(test::transposed(first_contour(test::transposed(m), config)).samples == contour.samples);
}

}  // namespace
}  // namespace trihedron::golden
