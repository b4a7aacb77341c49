// SPDX-License-Identifier: Apache-2.0
// Counts of vertices: registers, records and golden model are compared at the end of each run.
#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/test_frames.hpp"

using namespace trihedron;
using namespace trihedron::sim;

namespace {

Report run_squares(const std::vector<int>& sides, int vertex_limit) {
  Random random(3);
  std::vector<SourceFrame> frames;
  for (const int side : sides) frames.push_back(frame_of(squares(side, side, random)));
  RunOptions options;
  options.check = true;
  options.vertex_limit = vertex_limit;
  Report report = Simulator::instance().run(options, for_all_views(frames), nullptr);
  REQUIRE(report.passed());
  return report;
}

}  // namespace

TEST_CASE("frames of some thousand vertices are counted, each bit of the count in turn") {
  constexpr int kBits = 12;  // a frame of 32768 vertices takes a million clocks
  const std::uint32_t every_bit = (1u << kBits) - 1;
  std::uint32_t set = 0, clear = 0;
  for (const int side : {60, 100, 140, 180, 200, 260, 330}) {
    const std::uint32_t count = run_squares({side}, kMaxVertexLimit).views[2].last_vertices;
    set |= count;
    clear |= ~count;
  }
  CHECK((set & every_bit) == every_bit);
  CHECK((clear & every_bit) == every_bit);
}

TEST_CASE("any number of lost vertices flags its frame, also one of a single bit") {
  constexpr int kSidePx = 150;
  const auto all = static_cast<int>(run_squares({kSidePx}, kMaxVertexLimit).views[0].last_vertices);
  for (int lost = 1; lost < all; lost *= 2) {
    CAPTURE(lost);
    const Report report = run_squares({kSidePx}, all - lost);
    for (const ViewStatistics& view : report.views) {
      CHECK(view.last_vertices_lost == static_cast<std::uint32_t>(lost));
    }
  }
}

// One of some hundred thousand vertices of noise, at the lowest thresholds.
TEST_CASE("eight branches, as many as a ring of 16 pixels can have, do occur") {
  constexpr int kSidePx = 40;
  Random random(5757);
  const GreyImage noise = make_image(Pattern::kNoise, kSidePx, kSidePx, random, {});
  RunOptions options;
  options.check = true;
  options.thresholds.first_contour = {4, 26};
  options.thresholds.second_contour.support = 0;
  options.thresholds.vertices = {1, 1};
  std::vector<Vertex> vertices;
  const Report report =
      Simulator::instance().run(options, for_all_views({frame_of(noise)}),
                                [&](FrameResult&& frame) { vertices = frame.features.vertices; });
  REQUIRE(report.passed());
  const auto branches = [](const Vertex& a, const Vertex& b) { return a.branches < b.branches; };
  const Vertex most = *std::max_element(vertices.begin(), vertices.end(), branches);
  CHECK(most.branches == 8);
  CHECK((most.x == 20 && most.y == 16));
}
