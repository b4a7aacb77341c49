// SPDX-License-Identifier: Apache-2.0
#include "sim/simulator.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "golden/error.hpp"
#include "sim/test_frames.hpp"

using namespace trihedron;
using namespace trihedron::sim;
using Catch::Matchers::Contains;

namespace {

RunOptions checked() {
  RunOptions options;
  options.check = true;
  options.flush_timeout = 500;
  return options;
}

Report run_all(const RunOptions& options, const std::vector<SourceFrame>& frames) {
  return Simulator::instance().run(options, for_all_views(frames), nullptr);
}

bool equal(const ViewFeatures& a, const ViewFeatures& b) {
  return a.width == b.width && a.height == b.height &&
         std::equal(a.contour.begin(), a.contour.end(), b.contour.begin(), b.contour.end(),
                    [](const ContourBeat& p, const ContourBeat& q) {
                      return p.gx == q.gx && p.gy == q.gy && p.magnitude == q.magnitude &&
                             p.flags == q.flags;
                    }) &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    [](const Vertex& p, const Vertex& q) {
                      return p.x == q.x && p.y == q.y && p.branches == q.branches &&
                             p.pattern == q.pattern && p.strength == q.strength;
                    });
}

}  // namespace

TEST_CASE("each view gives the golden features of its own image") {
  const std::vector<GreyImage> views = {polygons(60, 40, 1), polygons(33, 50, 2),
                                        polygons(5, 5, 3)};
  const std::vector<ViewFeatures> features = simulate_views(views);
  REQUIRE(features.size() == 3);
  for (std::size_t v = 0; v < 3; ++v) {
    const GreyImage& image = views[v];
    CHECK(equal(features[v], golden::run_front_end(image.pixels.data(), image.width, image.height,
                                                   image.width)));
  }
}

TEST_CASE("tall frames that run together because a start is missing are expected as one") {
  SourceFrame lost = frame_of(polygons(6, 363, 3));
  lost.fault = Fault::kMissingStart;
  const SourceFrame good = frame_of(polygons(6, 363, 4));
  const Report report = run_all(checked(), {good, good, lost, good});
  REQUIRE(report.passed());
  CHECK(report.compared.frames == 3 * 3);
  CHECK(report.compared.beats == 3 * 4 * 6 * 363);
}

TEST_CASE("frames of one to four lines between good ones are too low, and only they") {
  std::vector<SourceFrame> frames;
  for (int height = 1; height < kMinSizePx; ++height) {
    frames.push_back(frame_of(polygons(20, 11, 7)));
    frames.push_back(frame_of(polygons(20, height, 8)));
  }
  frames.push_back(frame_of(polygons(20, 11, 9)));
  const Report report = run_all(checked(), frames);
  INFO((report.mismatch ? report.mismatch->text() : ""));
  REQUIRE(report.passed());
  CHECK(report.compared.frames == kViews * frames.size());
}

TEST_CASE(
    "a frame of unknown height ends FLUSH_TIMEOUT clocks after its last pixel, to the clock") {
  const auto clocks_until_out = [](int flush_timeout) {
    RunOptions options = checked();
    options.flush_timeout = flush_timeout;
    std::uint64_t clocks = 0;
    const Report report =
        Simulator::instance().run(options, for_all_views({frame_of(polygons(16, 12, 5))}),
                                  [&](FrameResult&& frame) { clocks = frame.clocks; });
    REQUIRE(report.passed());
    return clocks;
  };
  constexpr int kShortest = 32;
  const std::uint64_t shortest = clocks_until_out(kShortest);
  // Each bit of the counter alone once, up to what the testbench takes for a hang.
  for (const int timeout : {33, 34, 36, 40, 48, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384,
                            32768, 65536, 131072, 0x15555}) {
    INFO("FLUSH_TIMEOUT " << timeout);
    CHECK(clocks_until_out(timeout) - shortest == static_cast<std::uint64_t>(timeout - kShortest));
  }
}

TEST_CASE("a time-out that passes while a first line waits for its width ends that frame") {
  // The third width waits until the first has left, 12 lines of 1600 px behind it; by then the
  // time-out is over, and pixels without a start of frame wait.
  SourceFrame late = frame_of(polygons(9, 7, 4));
  late.fault = Fault::kMissingStart;
  late.gap_clocks = 2 * checked().flush_timeout;
  const Report report =
      run_all(checked(), {frame_of(polygons(1600, 5, 1)), frame_of(polygons(700, 5, 2)),
                          frame_of(polygons(8, 1, 3)), late, frame_of(polygons(30, 20, 5))});
  INFO((report.mismatch ? report.mismatch->text() : ""));
  REQUIRE(report.passed());
  CHECK(report.compared.frames == kViews * 4);
}

TEST_CASE("the frame tag wraps around after 256 frames, the counters do not") {
  const std::vector<SourceFrame> frames(260, frame_of(polygons(5, 5, 2)));
  const Report report = run_all(checked(), frames);
  REQUIRE(report.passed());
  CHECK(report.compared.frames == 3 * 260);
}

TEST_CASE("runs of one process do not influence each other") {
  RunOptions options = checked();
  options.pixel_idles = options.contour_stalls = options.vertex_stalls = {0.3, 4};
  const std::vector<SourceFrame> frames(2, frame_of(polygons(45, 31, 9)));
  const Report first = run_all(options, frames);
  run_all(checked(), {frame_of(polygons(20, 20, 1))});
  const Report again = run_all(options, frames);
  REQUIRE_FALSE(first.mismatch);
  CHECK(first.clocks == again.clocks);
  CHECK(first.views[1].input_idles > 0);
  CHECK(first.views[1].contour_stalls == again.views[1].contour_stalls);
  options.seed = 2;
  CHECK(run_all(options, frames).views[1].contour_stalls != first.views[1].contour_stalls);
}

TEST_CASE(
    "a golden model with another threshold differs, and the report says "
    "where") {
  RunOptions options = checked();
  options.expected_thresholds = options.thresholds;
  options.expected_thresholds->first_contour.noise_floor = 200;
  const Report report = run_all(options, {frame_of(polygons(60, 40, 1))});
  REQUIRE(report.mismatch);
  CHECK_FALSE(report.passed());
  CHECK(report.mismatch->stage == "first_contour");
  CHECK(report.mismatch->x >= 0);
  CHECK_THAT(report.mismatch->text(), Contains("seed 1") && Contains("expected 0, got 1"));
  // The next run starts from reset.
  CHECK(run_all(checked(), {frame_of(polygons(60, 40, 1))}).passed());
}

TEST_CASE("a run that compares nothing has not passed") {
  const Report report = run_all(checked(), {});
  CHECK_FALSE(report.mismatch);
  CHECK_FALSE(report.passed());
}

TEST_CASE("vertices beyond the limit are lost, counted and flagged") {
  RunOptions options = checked();
  options.vertex_limit = 1;
  std::vector<FrameResult> frames;
  const Report report =
      Simulator::instance().run(options, for_all_views({frame_of(polygons(90, 60, 12))}),
                                [&](FrameResult&& frame) { frames.push_back(std::move(frame)); });
  REQUIRE_FALSE(report.mismatch);
  REQUIRE(frames.size() == 3);
  CHECK(frames[0].features.vertices.size() == 1);
  CHECK(frames[0].features.vertices_lost > 0);
  CHECK(frames[0].status == 8);
}

TEST_CASE("what a frame source throws reaches the caller, and the next run is whole") {
  // Calls 1 to 6 find a bench that waits for lines, later ones find it running; of three views that
  // ask at a time the first, the second or the third fails.
  const int failing_call = GENERATE(1, 2, 5, 8, 10, 11, 12);
  int calls = 0;
  const FrameSource failing = [&](int) -> std::optional<SourceFrame> {
    if (++calls == failing_call) throw std::runtime_error("disk on fire");
    return frame_of(polygons(40, 80, 1));
  };
  CHECK_THROWS_WITH(Simulator::instance().run(checked(), failing, nullptr), "disk on fire");
  CHECK(run_all(checked(), {frame_of(polygons(40, 30, 1))}).passed());
}

TEST_CASE("what a frame sink throws reaches the caller, and the next run is whole") {
  const FrameSink failing = [](FrameResult&&) { throw std::runtime_error("disk full"); };
  const FrameSource source =
      for_all_views(std::vector<SourceFrame>(4, frame_of(polygons(9, 9, 1))));
  CHECK_THROWS_WITH(Simulator::instance().run(checked(), source, failing), "disk full");
  CHECK(run_all(checked(), {frame_of(polygons(40, 30, 1))}).passed());
}

TEST_CASE("images that the hardware does not take are refused by name of size") {
  CHECK_THROWS_WITH(simulate_views({polygons(4, 9, 1)}), Contains("4 x 9"));
  CHECK_THROWS_WITH(simulate_views({polygons(kMaxWidthPx + 1, 9, 1)}), Contains("1921 x 9"));
  CHECK_THROWS_AS(simulate_views({}), Error);
  CHECK_THROWS_AS(simulate_views(std::vector<GreyImage>(4, polygons(9, 9, 1))), Error);
}
