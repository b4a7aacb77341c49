// SPDX-License-Identifier: Apache-2.0
// docs/story.md follows one pixel through the hardware; these are its numbers.
#include <catch2/catch.hpp>

#include "io/scene.hpp"
#include "io/views.hpp"

using namespace trihedron;

TEST_CASE("the pixel of docs/story.md has the values that are told there") {
  const Scene scene = read_scene(TRIHEDRON_TESTVECTORS "/scenes/studio-two/000034");
  const ViewFeatures features = golden_front_end()({scene.images[0]}).front();
  constexpr int kX = 191, kY = 16;
  CHECK(scene.images[0].at<unsigned char>(kY, kX) == 129);
  const ContourBeat& beat = features.at(kX, kY);
  CHECK(beat.gx == -182);
  CHECK(beat.gy == 348);
  CHECK(beat.magnitude == 270);
  CHECK(beat.flags == (kContour | kFirstContour));
  const auto vertex = std::find_if(features.vertices.begin(), features.vertices.end(),
                                   [](const Vertex& v) { return v.x == kX && v.y == kY; });
  REQUIRE(vertex != features.vertices.end());
  CHECK(vertex->branches == 2);
  CHECK(vertex->pattern == 16 * 3 + 8);
  CHECK(vertex->strength == 46);
}
