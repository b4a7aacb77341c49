// SPDX-License-Identifier: Apache-2.0
#include "golden/gradient.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "images.hpp"

namespace trihedron::golden {
namespace {

using test::gradient_of;
using test::Image;

constexpr int kH[5][5] = {{-1, -6, 0, 6, 1},
                          {-4, -24, 0, 24, 4},
                          {-6, -36, 0, 36, 6},
                          {-4, -24, 0, 24, 4},
                          {-1, -6, 0, 6, 1}};
constexpr int kD[5][5] = {
    {-1, -2, -3, -1, 0}, {-2, -4, -5, 0, 1}, {-3, -5, 0, 5, 3}, {-1, 0, 5, 4, 2}, {0, 1, 3, 2, 1}};

/// Sum / 1024 in units of 1/kGradientScale, nearest, halves away from zero.
int scaled(double sum) { return static_cast<int>(std::round(sum * kGradientScale / 1024)); }

/// One pixel's gradient straight from the masks.
struct Sample {
  int gx, gy, magnitude;
};

Sample from_masks(const Image& image, int x, int y) {
  int h = 0, v = 0, d = 0, e = 0;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) {
      const int grey = image.at(x + i - 2, y + j - 2);
      h += kH[j][i] * grey;
      v += kH[i][j] * grey;
      d += kD[j][i] * grey;
      e += kD[j][4 - i] * grey;
    }
  }
  const int sum = std::abs(h) + std::abs(v) + 4 * std::abs(d) + 4 * std::abs(e);
  return {scaled(h + 8 * (d - e)), scaled(v + 8 * (d + e)), std::min(scaled(sum), kMaxMagnitude)};
}

bool is_zero(const GradientImage& g, int x, int y) {
  return g.gx.at(x, y) == 0 && g.gy.at(x, y) == 0 && g.magnitude.at(x, y) == 0;
}

TEST_CASE("a flat image has zero gradient") {
  for (const int grey : {0, 1, 128, 255}) {
    Image image(9, 7);
    std::fill(image.samples.begin(), image.samples.end(), static_cast<std::uint8_t>(grey));
    const GradientImage g = gradient_of(image);
    for (int y = 0; y < 7; ++y) {
      for (int x = 0; x < 9; ++x) REQUIRE(is_zero(g, x, y));
    }
  }
}

TEST_CASE("one bright pixel in a 5x5 window gives the hand-computed gradient") {
  Image image(5, 5);
  image.at(3, 2) = 128;
  // H = 36 * 128, V = 0, D = 5 * 128, E = -5 * 128; gx = 116 * 128 / 1024, mean = 76 * 128 / 1024.
  GradientImage g = gradient_of(image);
  CHECK(g.gx.at(2, 2) == 116);
  CHECK(g.gy.at(2, 2) == 0);
  CHECK(g.magnitude.at(2, 2) == 76);

  image.at(3, 2) = 0;
  image.at(0, 0) = 200;
  // H = V = -200, D = -200, E = 0: gx = -9 * 200 / 128 = -14.06, mean = 6 * 200 / 128 = 9.375.
  g = gradient_of(image);
  CHECK(g.gx.at(2, 2) == -14);
  CHECK(g.gy.at(2, 2) == -14);
  CHECK(g.magnitude.at(2, 2) == 9);
}

TEST_CASE("a plane has its exact slope") {
  Image image(24, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 24; ++x) image.at(x, y) = static_cast<std::uint8_t>(40 + 5 * x - 2 * y);
  }
  const GradientImage g = gradient_of(image);
  for (int y = 2; y < 18; ++y) {
    for (int x = 2; x < 22; ++x) {
      REQUIRE(g.gx.at(x, y) == 5 * kGradientScale);
      REQUIRE(g.gy.at(x, y) == -2 * kGradientScale);
      // (5 + 2 + 3/4 * 3 + 3/4 * 7) / 4 with gains 256/256 and 64/64: 3.625 grey levels per px.
      REQUIRE(g.magnitude.at(x, y) == 29);
    }
  }
}

TEST_CASE("the gradient is the masks' sum at every pixel and zero where the window leaves") {
  for (const auto& [width, height] : {std::pair{5, 5}, {6, 9}, {33, 17}, {64, 48}}) {
    const Image image = test::noise(width, height, static_cast<unsigned>(width));
    const GradientImage g = gradient_of(image);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (x < 2 || y < 2 || x >= width - 2 || y >= height - 2) {
          REQUIRE(is_zero(g, x, y));
          continue;
        }
        const Sample s = from_masks(image, x, y);
        REQUIRE(g.gx.at(x, y) == s.gx);
        REQUIRE(g.gy.at(x, y) == s.gy);
        REQUIRE(g.magnitude.at(x, y) == s.magnitude);
      }
    }
  }
}

TEST_CASE("rows further apart than the width are read by their stride") {
  const Image wide = test::noise(40, 12, 7);
  Image narrow(30, 12);
  for (int y = 0; y < 12; ++y) std::copy_n(wide.row(y), 30, narrow.row(y));
  const GradientImage g = gradient(wide.samples.data(), 30, 12, 40);
  CHECK(g.magnitude.samples == gradient_of(narrow).magnitude.samples);
  CHECK(g.gx.samples == gradient_of(narrow).gx.samples);
}

TEST_CASE("the slopes are OpenCV's convolution with the combined mask") {
  const Image image = test::noise(61, 43, 11);
  float combined[5][5];
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) {
      combined[j][i] = static_cast<float>(kH[j][i] + 8 * (kD[j][i] - kD[j][4 - i]));
    }
  }
  const cv::Mat grey(43, 61, CV_8U, const_cast<std::uint8_t*>(image.samples.data()));
  cv::Mat gx, gy;
  const cv::Mat mask(5, 5, CV_32F, combined);
  cv::filter2D(grey, gx, CV_32F, mask);
  cv::filter2D(grey, gy, CV_32F, mask.t());
  const GradientImage g = gradient_of(image);
  for (int y = 2; y < 41; ++y) {
    for (int x = 2; x < 59; ++x) {
      REQUIRE(g.gx.at(x, y) == scaled(gx.at<float>(y, x)));
      REQUIRE(g.gy.at(x, y) == scaled(gy.at<float>(y, x)));
    }
  }
}

TEST_CASE("mirroring, transposing and inverting the image does the same to the gradient") {
  const Image image = test::noise(31, 23, 3);
  const GradientImage g = gradient_of(image);

  const GradientImage m = gradient_of(test::mirrored(image));
  CHECK(test::mirrored(m.magnitude).samples == g.magnitude.samples);
  CHECK(test::mirrored(m.gy).samples == g.gy.samples);
  const auto mirrored_gx = test::mirrored(m.gx);

  const GradientImage t = gradient_of(test::transposed(image));
  CHECK(test::transposed(t.magnitude).samples == g.magnitude.samples);
  CHECK(test::transposed(t.gx).samples == g.gy.samples);
  CHECK(test::transposed(t.gy).samples == g.gx.samples);

  Image negative = image;
  for (auto& sample : negative.samples) sample = static_cast<std::uint8_t>(255 - sample);
  const GradientImage n = gradient_of(negative);
  CHECK(n.magnitude.samples == g.magnitude.samples);
  for (std::size_t i = 0; i < g.gx.samples.size(); ++i) {
    REQUIRE(mirrored_gx.samples[i] == -g.gx.samples[i]);
    REQUIRE(n.gx.samples[i] == -g.gx.samples[i]);
    REQUIRE(n.gy.samples[i] == -g.gy.samples[i]);
  }
}

TEST_CASE("a grey offset does not change the gradient, a gain scales it") {
  Image image = test::noise(31, 23, 5);
  for (auto& sample : image.samples) sample /= 8;
  const GradientImage g = gradient_of(image);
  Image offset = image, gain = image;
  for (auto& sample : offset.samples) sample = static_cast<std::uint8_t>(sample + 200);
  for (auto& sample : gain.samples) sample = static_cast<std::uint8_t>(sample * 4);
  CHECK(gradient_of(offset).magnitude.samples == g.magnitude.samples);
  CHECK(gradient_of(offset).gx.samples == g.gx.samples);
  const GradientImage scaled_up = gradient_of(gain);
  // 4 times a value rounded to half a unit, against the rounded value: 4 * 1/2 + 1/2.
  constexpr double kRounding = 2.5;
  for (std::size_t i = 0; i < g.gx.samples.size(); ++i) {
    REQUIRE(std::abs(scaled_up.gx.samples[i] - 4 * g.gx.samples[i]) <= kRounding);
    REQUIRE(std::abs(scaled_up.magnitude.samples[i] - 4 * g.magnitude.samples[i]) <= kRounding);
  }
}

TEST_CASE("the extreme windows reach the widest values and stay inside their bits") {
  Image slope_x(5, 5), all(5, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      slope_x.at(x, y) = kH[y][x] + 8 * (kD[y][x] - kD[y][4 - x]) > 0 ? 255 : 0;
      all.at(x, y) = kH[y][x] + kH[x][y] + 4 * kD[y][x] + 4 * kD[y][4 - x] > 0 ? 255 : 0;
    }
  }
  const int widest = gradient_of(slope_x).gx.at(2, 2);
  CHECK(widest == 765);  // 384 * 255 / 1024 * 8
  CHECK(widest < 1 << (kSlopeBits - 1));
  CHECK(gradient_of(all).magnitude.at(2, 2) == kMaxMagnitude);
}

TEST_CASE("the gradient of a blurred straight edge points across it") {
  // Integer rounding of a 200-level edge turns it by less than 0.1 degrees, the masks by 0.7.
  constexpr double kMaxTurnDeg = 0.8;
  constexpr double kBlurPx = 0.7;
  for (int degrees = 0; degrees < 360; degrees += 3) {
    const double angle = degrees * M_PI / 180;
    Image image(5, 5);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 5; ++x) {
        const double across = (x - 2) * std::cos(angle) + (y - 2) * std::sin(angle);
        const double grey = 128 + 100 * std::erf(across / kBlurPx / std::sqrt(2.0));
        image.at(x, y) = static_cast<std::uint8_t>(std::lround(grey));
      }
    }
    const GradientImage g = gradient_of(image);
    const double gx = g.gx.at(2, 2), gy = g.gy.at(2, 2);
    const double turn = std::atan2(gy * std::cos(angle) - gx * std::sin(angle),
                                   gx * std::cos(angle) + gy * std::sin(angle));
    INFO("edge normal at " << degrees << " degrees");
    CHECK(std::abs(turn) * 180 / M_PI < kMaxTurnDeg);
  }
}

}  // namespace
}  // namespace trihedron::golden
