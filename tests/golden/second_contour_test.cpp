// SPDX-License-Identifier: Apache-2.0
#include "golden/second_contour.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "golden/first_contour.hpp"
#include "images.hpp"

namespace trihedron::golden {
namespace {

using Bits = Plane<std::uint8_t>;

cv::Mat as_mat(const Bits& bits) {
  return cv::Mat(bits.height, bits.width, CV_8U, const_cast<std::uint8_t*>(bits.samples.data()));
}

int pieces(const Bits& bits) {
  cv::Mat labels;
  return cv::connectedComponents(as_mat(bits), labels, 8) - 1;
}

int holes(const Bits& bits) {
  cv::Mat labels;
  return cv::connectedComponents(as_mat(bits) == 0, labels, 4) - 2;
}

std::vector<cv::Point> links_of(const Bits& bits, cv::Point p) {
  std::vector<cv::Point> found;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      if ((i != 0 || j != 0) && bits.at(p.x + i, p.y + j)) found.emplace_back(p.x + i, p.y + j);
    }
  }
  return found;
}

/// Groups of touching pixels, merged one by one.
int groups(std::vector<cv::Point> points) {
  int n = 0;
  while (!points.empty()) {
    std::vector<cv::Point> front{points.back()};
    points.pop_back();
    ++n;
    while (!front.empty()) {
      const cv::Point p = front.back();
      front.pop_back();
      for (std::size_t i = points.size(); i-- > 0;) {
        if (std::abs(points[i].x - p.x) > 1 || std::abs(points[i].y - p.y) > 1) continue;
        front.push_back(points[i]);
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
  return n;
}

bool linked_by_definition(const Bits& ridge, int x, int y) {
  if (x < 2 || y < 2 || x >= ridge.width - 2 || y >= ridge.height - 2) return false;
  const auto links = links_of(ridge, {x, y});
  if (ridge.at(x, y)) return !links.empty();
  return groups(links) >= 2 && std::any_of(links.begin(), links.end(), [&](cv::Point p) {
           return links_of(ridge, p).size() == 1;
         });
}

Plane<std::uint16_t> flat(const Bits& like, std::uint16_t value) {
  Plane<std::uint16_t> magnitude(like.width, like.height);
  std::fill(magnitude.samples.begin(), magnitude.samples.end(), value);
  return magnitude;
}

void check_against_definition(const Bits& ridge) {
  const Bits linked = link(ridge, flat(ridge, 12), 12);
  for (int y = 0; y < ridge.height; ++y) {
    for (int x = 0; x < ridge.width; ++x) {
      REQUIRE(linked.at(x, y) == linked_by_definition(ridge, x, y));
    }
  }
}

GradientImage vertical_ridge(const std::vector<int>& profile) {
  const int width = static_cast<int>(profile.size());
  GradientImage g{Plane<std::int16_t>(width, 7), Plane<std::int16_t>(width, 7),
                  Plane<std::uint16_t>(width, 7)};
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < width; ++x) {
      g.magnitude.at(x, y) = static_cast<std::uint16_t>(profile[static_cast<std::size_t>(x)]);
      g.gx.at(x, y) = 30;
    }
  }
  return g;
}

Bits all_first(const GradientImage& g) {
  Bits first(g.gx.width, g.gx.height);
  std::fill(first.samples.begin(), first.samples.end(), std::uint8_t{1});
  return first;
}

TEST_CASE("the ridge is the highest column, the left one of two equal ones") {
  const GradientImage peak = vertical_ridge({0, 10, 20, 40, 30, 10, 0});
  const GradientImage tie = vertical_ridge({0, 10, 40, 40, 30, 10, 0});
  for (int y = 2; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      CHECK(ridge(peak, all_first(peak), {}).at(x, y) == (x == 3));
      CHECK(ridge(tie, all_first(tie), {}).at(x, y) == (x == 2));
    }
  }
  CHECK(ridge(peak, all_first(peak), {}).at(3, 1) == 0);
}

TEST_CASE("the ridge needs first contour of its own and support around it") {
  const GradientImage peak = vertical_ridge({0, 0, 0, 30, 0, 0, 0});
  Bits first = all_first(peak);
  CHECK(ridge(peak, first, {150}).at(3, 3) == 1);
  CHECK(ridge(peak, first, {151}).at(3, 3) == 0);
  first.at(3, 1) = 0;
  CHECK(ridge(peak, first, {120}).at(3, 3) == 1);
  CHECK(ridge(peak, first, {121}).at(3, 3) == 0);
  first.at(3, 3) = 0;
  CHECK(ridge(peak, first, {0}).at(3, 3) == 0);
}

TEST_CASE("the step across the contour follows the gradient's octant") {
  // The centre is highest along one step only; the gradient decides whether that step counts.
  struct Case {
    int gx, gy, sx, sy;
  };
  for (const auto& [gx, gy, sx, sy] :
       {Case{9, 4, 1, 0}, Case{-9, 4, 1, 0}, Case{8, 4, 1, 1}, Case{4, -9, 0, 1}, Case{4, 8, 1, 1},
        Case{-5, -5, 1, 1}, Case{-5, 5, 1, -1}, Case{8, -4, 1, -1}, Case{0, 0, 1, 1}}) {
    for (const auto& [ox, oy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
      GradientImage g = vertical_ridge({50, 50, 50, 50, 50});
      g.magnitude.at(2, 2) = 40;
      g.magnitude.at(2 + ox, 2 + oy) = g.magnitude.at(2 - ox, 2 - oy) = 30;
      g.gx.at(2, 2) = static_cast<std::int16_t>(gx);
      g.gy.at(2, 2) = static_cast<std::int16_t>(gy);
      INFO("gradient " << gx << ", " << gy << " step " << ox << ", " << oy);
      CHECK(ridge(g, all_first(g), {0}).at(2, 2) == (ox == sx && oy == sy));
    }
  }
}

TEST_CASE("every ring of ridge pixels around a gap is linked as defined") {
  for (unsigned ring = 0; ring < 256; ++ring) {
    for (const int tail : {0, 1, 2, 3}) {
      Bits bits(9, 9);
      unsigned k = 0;
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          if (i != 0 || j != 0) bits.at(4 + i, 4 + j) = ring >> k++ & 1;
        }
      }
      if (tail & 1) bits.at(2, 4) = 1;
      if (tail & 2) bits.at(6, 6) = 1;
      INFO("ring " << ring << " tail " << tail);
      check_against_definition(bits);
    }
  }
}

TEST_CASE("linking keeps the pieces of every small image but lone pixels, or joins them") {
  for (unsigned image = 0; image < 1U << 16; ++image) {
    Bits bits(8, 8), linked_only(8, 8);
    for (unsigned i = 0; i < 16; ++i)
      bits.at(2 + static_cast<int>(i % 4), 2 + static_cast<int>(i / 4)) = image >> i & 1;
    for (int y = 2; y < 6; ++y) {
      for (int x = 2; x < 6; ++x)
        linked_only.at(x, y) = bits.at(x, y) && !links_of(bits, {x, y}).empty();
    }
    const Bits linked = link(bits, flat(bits, 12), 12);
    // Nothing but lone pixels goes, no piece falls apart, and no hole is filled.
    for (std::size_t i = 0; i < linked.samples.size(); ++i)
      REQUIRE(linked.samples[i] >= linked_only.samples[i]);
    INFO("image " << image);
    REQUIRE(pieces(linked) <= pieces(linked_only));
    REQUIRE(holes(linked) >= holes(linked_only));
  }
}

TEST_CASE("linking random ridges follows the definition and never parts a piece") {
  std::mt19937 random(23);
  for (int round = 0; round < 30; ++round) {
    Bits bits(30, 24);
    for (int y = 2; y < 22; ++y) {
      for (int x = 2; x < 28; ++x)
        bits.at(x, y) = random() % 16 < 2U + static_cast<unsigned>(round) % 5;
    }
    check_against_definition(bits);
    Bits linked_only = bits;
    for (int y = 2; y < 22; ++y) {
      for (int x = 2; x < 28; ++x) {
        if (links_of(bits, {x, y}).empty()) linked_only.at(x, y) = 0;
      }
    }
    const Bits linked = link(bits, flat(bits, 12), 12);
    CHECK(pieces(linked) <= pieces(linked_only));
  }
}

TEST_CASE("a gap below the noise floor stays open") {
  Bits bits(11, 5);
  for (const int x : {2, 3, 5, 6}) bits.at(x, 2) = 1;
  CHECK(link(bits, flat(bits, 12), 12).at(4, 2) == 1);
  CHECK(link(bits, flat(bits, 11), 12).at(4, 2) == 0);
}

/// The sharpest corner, degrees.
double sharpest(const std::vector<cv::Point>& polygon) {
  double least = 180;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const cv::Point a = polygon[(i + n - 1) % n] - polygon[i];
    const cv::Point b = polygon[(i + 1) % n] - polygon[i];
    least = std::min(least, std::acos(a.ddot(b) / cv::norm(a) / cv::norm(b)) * 180 / M_PI);
  }
  return least;
}

/// A convex polygon around the middle in 1/16 px, no corner sharper than 60 degrees: there the
/// two flanks' windows overlap and the ridge may end early.
std::vector<cv::Point> random_polygon(std::mt19937& random, int centre) {
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::uniform_int_distribution<int> corners(3, 6);
  const double radius = 0.75 * centre;
  std::vector<cv::Point> polygon;
  do {
    const int n = corners(random);
    const double turn = 10 * jitter(random);
    polygon.clear();
    for (int i = 0; i < n; ++i) {
      const double angle = turn + (i + jitter(random)) * 2 * M_PI / n;
      polygon.emplace_back(cvRound(16 * (centre + radius * std::cos(angle))),
                           cvRound(16 * (centre + radius * std::sin(angle))));
    }
  } while (sharpest(polygon) < 60);
  return polygon;
}

TEST_CASE("the contour of a polygon is one closed curve, one pixel wide") {
  std::mt19937 random(5);
  constexpr int kSide = 96;
  for (int round = 0; round < 100; ++round) {
    cv::Mat grey(kSide, kSide, CV_8U, cv::Scalar(60));
    const std::vector<std::vector<cv::Point>> polygons{random_polygon(random, kSide / 2)};
    cv::fillPoly(grey, polygons, cv::Scalar(170), cv::LINE_AA, 4);
    cv::GaussianBlur(grey, grey, {}, 0.6);
    const GradientImage g = gradient(grey.data, kSide, kSide, kSide);
    const Bits contour = second_contour(g, first_contour(g.magnitude, {}), 12, {});
    INFO("polygon " << round << " with " << polygons[0].size() << " corners");
    CHECK(pieces(contour) == 1);
    CHECK(holes(contour) == 1);
    for (int y = 2; y < kSide - 2; ++y) {
      for (int x = 2; x < kSide - 2; ++x) {
        if (!contour.at(x, y)) continue;
        CHECK(links_of(contour, {x, y}).size() >= 2);
        CHECK_FALSE((contour.at(x + 1, y) && contour.at(x, y + 1) && contour.at(x + 1, y + 1)));
      }
    }
  }
}

}  // namespace
}  // namespace trihedron::golden
