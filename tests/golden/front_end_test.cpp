// SPDX-License-Identifier: Apache-2.0
#include "golden/front_end.hpp"

#include <catch2/catch.hpp>

#include "golden/error.hpp"
#include "images.hpp"

namespace trihedron::golden {
namespace {

TEST_CASE("the features are the stages' outputs put together") {
  const test::Image image = test::noise(50, 40, 13);
  const FrontEndConfig config{{10, 25}, {100}, {16, 4}};
  const ViewFeatures f = run_front_end(image.samples.data(), 50, 40, 50, config);
  const GradientImage g = test::gradient_of(image);
  const auto first = first_contour(g.magnitude, config.first_contour);
  const auto second = second_contour(g, first, 10, config.second_contour);
  REQUIRE(f.width == 50);
  REQUIRE(f.height == 40);
  REQUIRE(f.contour.size() == 2000);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 50; ++x) {
      const ContourBeat& beat = f.at(x, y);
      REQUIRE(beat.gx == g.gx.at(x, y));
      REQUIRE(beat.gy == g.gy.at(x, y));
      REQUIRE(beat.magnitude == g.magnitude.at(x, y));
      REQUIRE(beat.flags == (second.at(x, y) * kContour | first.at(x, y) * kFirstContour));
    }
  }
  const std::vector<Vertex> corners = vertices(g, second, config.vertices);
  REQUIRE(f.vertices.size() == corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    REQUIRE(f.vertices[i].x == corners[i].x);
    REQUIRE(f.vertices[i].y == corners[i].y);
    REQUIRE(f.vertices[i].branches == corners[i].branches);
    REQUIRE(f.vertices[i].pattern == corners[i].pattern);
    REQUIRE(f.vertices[i].strength == corners[i].strength);
  }
}

TEST_CASE("the smallest legal frame is one window, smaller ones are refused") {
  const test::Image image = test::noise(5, 5, 1);
  CHECK(run_front_end(image.samples.data(), 5, 5, 5).contour.size() == 25);
  CHECK_THROWS_AS(run_front_end(image.samples.data(), 4, 5, 5), Error);
  CHECK_THROWS_WITH(run_front_end(image.samples.data(), 5, 4, 5),
                    "image is 5 x 4 px, the front end needs at least 5 x 5");
}

}  // namespace
}  // namespace trihedron::golden
