// SPDX-License-Identifier: Apache-2.0
#include "sim/regression.hpp"

#include <catch2/catch.hpp>

#include "sim/functional_coverage.hpp"

using namespace trihedron::sim;

TEST_CASE("a case follows from its seed alone") {
  const RegressionCase a = make_case(42), b = make_case(42);
  CHECK(a.frames[2].back().image.pixels == b.frames[2].back().image.pixels);
  CHECK(a.options.pixel_idles.probability == b.options.pixel_idles.probability);
  CHECK(static_cast<int>(a.frames[0].size() + a.frames[1].size() + a.frames[2].size()) ==
        frames_in_case(42));
}

TEST_CASE("a hundred cases hold every kind of trouble") {
  int faults = 0, stalls = 0, limits = 0, known_heights = 0, smallest = 0, widest = 0, tallest = 0;
  int too_tall = 0, too_wide = 0, resets = 0, polls = 0, changes = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const RegressionCase one = make_case(seed);
    stalls += one.options.contour_stalls.probability > 0;
    limits += one.options.vertex_limit < kMaxVertexLimit;
    known_heights += one.options.frame_height > 0;
    resets += one.options.prelude_clocks > 0;
    polls += one.options.poll_registers;
    changes += !one.options.changes.empty();
    for (const auto& sequence : one.frames) {
      for (const SourceFrame& frame : sequence) {
        faults += frame.fault != Fault::kNone;
        smallest += frame.image.width == kMinSizePx && frame.image.height == kMinSizePx;
        widest += frame.image.width == kMaxWidthPx;
        tallest += frame.image.height == kMaxHeightPx;
        too_tall += frame.image.height > kMaxHeightPx;
        too_wide += frame.image.width > kMaxWidthPx;
      }
    }
  }
  CHECK(faults > 20);
  CHECK(stalls > 20);
  CHECK(limits > 5);
  CHECK(known_heights > 5);
  CHECK(smallest > 5);
  CHECK(widest > 0);
  CHECK(tallest > 0);
  CHECK(too_tall > 0);
  CHECK(too_wide > 0);
  CHECK(resets > 5);
  CHECK(polls > 10);
  CHECK(changes > 10);
}

TEST_CASE("twelve random cases are equal to the golden model, and their coverage is counted") {
  FunctionalCoverage coverage;
  std::uint64_t pixels = 0, counted = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Report report = run_case(make_case(seed), &coverage);
    INFO("seed " << seed << ": " << (report.mismatch ? report.mismatch->text() : ""));
    CHECK(report.passed());
    pixels += report.compared.beats;
  }
  for (const auto& [bin, hits] : coverage.groups().at("magnitude")) counted += hits;
  CHECK(counted == pixels);
  CHECK_THROWS_WITH(coverage.add("magnitude", "unheard of"), Catch::Contains("unheard of"));
}

TEST_CASE("a run after a reset in mid-frame is the run after power-on") {
  RegressionCase one = make_case(7);
  one.options.prelude_clocks = 0;
  const Report fresh = run_case(one);
  one.options.prelude_clocks = 777;
  const Report after = run_case(one);
  REQUIRE(fresh.passed());
  REQUIRE(after.passed());
  CHECK(after.clocks == fresh.clocks);
  CHECK(after.compared.beats == fresh.compared.beats);
}
