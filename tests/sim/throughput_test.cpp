// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/test_frames.hpp"

using namespace trihedron;
using namespace trihedron::sim;

namespace {

struct Size {
  int width;
  int height;
};

/// Once per run: the first line decides the frame's width.
constexpr std::uint64_t kFirstLineStalls = 4;

/// Frames of these sizes one behind the other, a pixel offered at every clock, outputs always
/// ready.
Report back_to_back(const std::vector<Size>& sizes, int frame_height = 0) {
  std::vector<SourceFrame> frames;
  for (const Size& size : sizes) frames.push_back(frame_of(polygons(size.width, size.height, 4)));
  RunOptions options;
  options.check = true;
  options.flush_timeout = 500;
  options.frame_height = frame_height;
  const Report report = Simulator::instance().run(options, for_all_views(frames), nullptr);
  REQUIRE_FALSE(report.mismatch);
  REQUIRE(report.compared.frames == kViews * sizes.size());
  for (const ViewStatistics& view : report.views) REQUIRE(view.input_idles == 0);
  return report;
}

}  // namespace

TEST_CASE("frames of one size go in back to back at one pixel per clock") {
  const Size size = GENERATE(Size{5, 5}, Size{5, 300}, Size{6, 9}, Size{17, 5}, Size{50, 40},
                             Size{641, 12}, Size{1920, 6});
  CAPTURE(size.width, size.height);
  for (const ViewStatistics& view : back_to_back({size, size, size, size}).views) {
    CHECK(view.pixels == static_cast<std::uint64_t>(4 * size.width * size.height));
    CHECK(view.input_stalls <= kFirstLineStalls);
  }
}

TEST_CASE("frames of one width and any heights go in back to back at one pixel per clock") {
  const int width = GENERATE(5, 8, 61);
  CAPTURE(width);
  for (const ViewStatistics& view :
       back_to_back({{width, 40}, {width, 5}, {width, 6}, {width, 23}, {width, 5}}).views) {
    CHECK(view.input_stalls <= kFirstLineStalls);
  }
}

// Rows until a frame's end has come out: two for each of gradient, first_contour, ridge,
// second_contour and the two windows of vertices; then 96 beats for columns and arithmetic.
constexpr int kDrainRows = 12;
constexpr int kDrainBeats = 96;
/// For a new width to come in force.
constexpr int kChangeClocks = 4;

TEST_CASE("a wider frame goes in at once, a narrower one waits for the rest of the wide one") {
  const int from = GENERATE(5, 40, 300);
  const int to = GENERATE(7, 60, 299);
  CAPTURE(from, to);
  // Each of the rows that push the old frame out is as long as one of that frame.
  const int rows = kDrainRows + kDrainBeats / from + 1;
  const auto bound =
      static_cast<std::uint64_t>(kFirstLineStalls + kChangeClocks + rows * std::max(0, from - to));
  for (const ViewStatistics& view : back_to_back({{from, 40}, {to, 40}}).views) {
    CHECK(view.input_stalls <= bound);
  }
}

TEST_CASE("frames of ever wider lines go in without a pause") {
  for (const ViewStatistics& view :
       back_to_back({{5, 40}, {6, 40}, {40, 20}, {41, 20}, {300, 15}, {640, 6}}).views) {
    CHECK(view.input_stalls <= kFirstLineStalls + 5 * kChangeClocks);
  }
}

// Behind a frame of few rows void rows must push it out.
TEST_CASE("a third width waits until the first has left, for a drain at most") {
  const Size low = GENERATE(Size{40, 5}, Size{40, 11}, Size{300, 5});
  CAPTURE(low.width, low.height);
  constexpr int kFirst = 120, kThird = 200;
  constexpr std::uint64_t kDrainClocks = kDrainRows * std::max(kFirst, 300) + kDrainBeats;
  for (const ViewStatistics& view :
       back_to_back({{kFirst, 20}, low, {kThird, 20}, low, {kFirst, 20}}).views) {
    CHECK(view.input_stalls <= kFirstLineStalls + 4 * (kDrainClocks + kChangeClocks));
  }
}

TEST_CASE(
    "new settings wait for the frame before to leave, not for the end of the row that pushes it") {
  constexpr int kWidthPx = 600;
  constexpr std::uint64_t kSwitchClocks = 40;
  SourceFrame holds = frame_of(polygons(kWidthPx, 8, 4));
  holds.holds = true;
  RunOptions options;
  options.check = true;
  SettingsChange change;
  change.thresholds.first_contour.noise_floor = 30;
  options.changes = {change};
  const std::vector<SourceFrame> frames{holds, frame_of(polygons(kWidthPx, 8, 5))};
  const Report report = Simulator::instance().run(options, for_all_views(frames), nullptr);
  REQUIRE(report.passed());
  // Its last row goes out while nothing more comes in, then eleven void rows and 96 beats.
  for (const ViewStatistics& view : report.views) {
    CHECK(view.input_stalls >= kDrainRows * kWidthPx);
    CHECK(view.input_stalls <= kDrainRows * kWidthPx + kDrainBeats + kSwitchClocks);
  }
}

// Slots longer than their rows pass what earlier frames left in the line memories.
TEST_CASE("frames of any widths in turn know nothing of each other") {
  Random random(GENERATE(range(0u, 4u)));
  std::vector<SourceFrame> frames;
  for (int i = 0; i < 150; ++i) {
    frames.push_back(frame_of(squares(random.between(5, 90), random.between(5, 30), random)));
  }
  RunOptions options;
  options.check = true;
  options.flush_timeout = 500;
  const Report report = Simulator::instance().run(options, for_all_views(frames), nullptr);
  REQUIRE(report.passed());
  REQUIRE(report.compared.frames == kViews * frames.size());
}

TEST_CASE(
    "what a reset left in the memories beside a narrow frame stays unseen in a wider one's slots") {
  RunOptions options;
  options.check = true;
  options.flush_timeout = 500;
  for (options.seed = 1; options.seed <= 40; ++options.seed) {
    options.prelude_clocks = 1000 + 37 * static_cast<int>(options.seed);
    const std::vector<SourceFrame> frames{frame_of(polygons(5 + options.seed % 8, 16, 4)),
                                          frame_of(polygons(60, 12, 4))};
    const Report report = Simulator::instance().run(options, for_all_views(frames), nullptr);
    CAPTURE(options.seed);
    REQUIRE(report.passed());
    REQUIRE(report.compared.frames == kViews * frames.size());
  }
}

TEST_CASE("a contour beat leaves at most ten lines and 64 clocks after its pixel came in") {
  const Size size = GENERATE(Size{5, 8}, Size{50, 40}, Size{450, 12}, Size{1920, 12});
  CAPTURE(size.width);
  // The height is known, so the last frame's end waits for no time-out.
  for (const ViewStatistics& view : back_to_back({size, size}, size.height).views) {
    CHECK(view.latency_clocks <= static_cast<std::uint64_t>(10 * size.width + 64));
  }
}

TEST_CASE("a receiver that stops until every pixel that can wait does loses none") {
  // Longer than the ring of pixels, 2048, and the pipeline's own rows can go on taking pixels.
  const StallProfile stops{0.0004, 6000};
  const Size size = GENERATE(Size{5, 700}, Size{61, 60}, Size{1918, 7});
  CAPTURE(size.width);
  RunOptions options;
  options.check = true;
  options.contour_stalls = options.vertex_stalls = stops;
  const std::vector<SourceFrame> frames(2, frame_of(polygons(size.width, size.height, 6)));
  const Report report = Simulator::instance().run(options, for_all_views(frames), nullptr);
  INFO((report.mismatch ? report.mismatch->text() : ""));
  REQUIRE(report.passed());
  for (const ViewStatistics& view : report.views) CHECK(view.input_stalls > 500);
}

TEST_CASE("the last frame of known height is drained once 16 clocks have brought nothing") {
  const auto clocks_until_out = [](int frame_height, int flush_timeout) {
    RunOptions options;
    options.check = true;
    options.frame_height = frame_height;
    options.flush_timeout = flush_timeout;
    std::uint64_t clocks = 0;
    const Report report =
        Simulator::instance().run(options, for_all_views({frame_of(polygons(16, 12, 5))}),
                                  [&](FrameResult&& frame) { clocks = frame.clocks; });
    REQUIRE(report.passed());
    return clocks;
  };
  // An end by time-out has to be announced first, through the registers of guard and row_slots.
  constexpr std::uint64_t kMostAnnounceClocks = 6;
  const std::uint64_t later = clocks_until_out(0, 100) - clocks_until_out(12, 100);
  CHECK(later >= 100 - 16);
  CHECK(later <= 100 - 16 + kMostAnnounceClocks);
}
