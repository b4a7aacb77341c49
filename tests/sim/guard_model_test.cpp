// SPDX-License-Identifier: Apache-2.0
#include "sim/guard_model.hpp"

#include <catch2/catch.hpp>

#include "sim/test_frames.hpp"

using namespace trihedron::sim;

namespace {

constexpr int kTimeout = 100;

struct Outcome {
  std::vector<ExpectedFrame> frames;
  std::uint32_t kinds = 0;
  std::uint32_t errors = 0;
};

Outcome guarded(const std::vector<SourceFrame>& sent, int frame_height = 0) {
  GuardModel guard({{frame_height}}, kTimeout);
  Outcome outcome;
  for (const SourceFrame& frame : sent) {
    for (const WireLinePtr& line : make_wire_lines(frame)) guard.feed(*line, outcome.frames);
  }
  guard.finish(outcome.frames);
  outcome.kinds = guard.event_kinds();
  outcome.errors = guard.errors();
  return outcome;
}

SourceFrame faulty(int width, int height, Fault fault, int line, int pixels = 1) {
  SourceFrame frame = frame_of(polygons(width, height, 5));
  frame.fault = fault;
  frame.fault_line = line;
  frame.fault_px = pixels;
  return frame;
}

SourceFrame good(int width, int height) { return faulty(width, height, Fault::kNone, 0); }

}  // namespace

TEST_CASE("good frames pass whole, whatever their sizes") {
  const Outcome outcome = guarded({good(9, 7), good(9, 12), good(5, 5), good(64, 6)});
  REQUIRE(outcome.frames.size() == 4);
  CHECK(outcome.errors == 0);
  CHECK(outcome.frames[3].image.pixels == good(64, 6).image.pixels);
  for (const ExpectedFrame& frame : outcome.frames) CHECK(frame.end == FrameEnd::kClean);
}

TEST_CASE("a bad line cuts its frame after the last good line and the next frame is whole") {
  const auto cut = [](Fault fault, GuardEvent event) {
    const Outcome outcome = guarded({faulty(20, 15, fault, 8), good(20, 15)});
    INFO("event " << event);
    REQUIRE(outcome.frames.size() == 2);
    CHECK(outcome.frames[0].image.height == 8);
    CHECK(outcome.frames[0].end == FrameEnd::kBadLine);
    CHECK(outcome.frames[1].image.height == 15);
    CHECK(outcome.frames[1].end == FrameEnd::kClean);
    CHECK(outcome.kinds == 1u << event);
    CHECK(outcome.errors == 1);
  };
  cut(Fault::kShortLine, kShortLineEvent);
  cut(Fault::kLongLine, kLongLineEvent);
}

TEST_CASE("a start of frame inside a line begins a frame of the rest of that line") {
  const Outcome outcome = guarded({faulty(20, 15, Fault::kEarlyStart, 8, 4), good(20, 15)});
  REQUIRE(outcome.frames.size() == 3);
  CHECK(outcome.frames[0].image.height == 8);
  CHECK(outcome.frames[0].end == FrameEnd::kBadLine);
  CHECK(outcome.frames[1].image.width == 16);
  CHECK(outcome.frames[1].image.height == 1);
  CHECK(outcome.frames[1].end == FrameEnd::kBadLine);
  CHECK(outcome.frames[2].image.height == 15);
  CHECK(outcome.kinds == (1u << kEarlyStartEvent | 1u << kLongLineEvent));
}

TEST_CASE("lines without a start of frame are dropped after a frame that has ended") {
  SourceFrame lost = faulty(20, 15, Fault::kMissingStart, 0);
  lost.gap_clocks = kTimeout + 1;
  const Outcome outcome = guarded({good(20, 15), lost, good(20, 15)});
  CHECK(outcome.frames.size() == 2);
  CHECK(outcome.kinds == 1u << kNoStartEvent);
  CHECK(outcome.errors == 1);
}

TEST_CASE("with the height known, a frame ends without another one and short ones are flagged") {
  const Outcome outcome =
      guarded({good(20, 15), faulty(20, 15, Fault::kCutFrame, 9), good(20, 15)}, 15);
  REQUIRE(outcome.frames.size() == 3);
  CHECK(outcome.frames[1].image.height == 10);
  CHECK(outcome.frames[1].end == FrameEnd::kBadHeight);
  CHECK(outcome.kinds == 1u << kEarlyStartEvent);
}

TEST_CASE("frames of a view that is off are dropped without notice, whatever they are") {
  GuardModel guard({{0, true}, {0, false}, {0, true}}, kTimeout);
  std::vector<ExpectedFrame> frames;
  SourceFrame holds = good(20, 15);
  holds.holds = true;
  const std::vector<SourceFrame> sent = {holds, faulty(20, 15, Fault::kShortLine, 4), good(4, 9),
                                         holds, good(9, 9)};
  for (const SourceFrame& frame : sent) {
    for (const WireLinePtr& line : make_wire_lines(frame)) guard.feed(*line, frames);
  }
  guard.finish(frames);
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].image.width == 20);
  CHECK(frames[1].image.width == 9);
  CHECK(frames[1].changes == 2);
  CHECK(guard.errors() == 0);
}

TEST_CASE("a pixel that brings two events is one error") {
  // The one-pixel frame ends a frame of one row and is itself too narrow.
  const Outcome outcome = guarded({faulty(20, 15, Fault::kCutFrame, 0), good(1, 1), good(9, 9)});
  CHECK(outcome.kinds == (1u << kTooFewRowsEvent | 1u << kTooNarrowEvent));
  CHECK(outcome.errors == 1);
}

TEST_CASE("a pixel that waits between two events for new settings is two errors") {
  const auto errors = [](int thresholds) {
    GuardModel guard({{15, true, 0}, {15, true, thresholds}}, kTimeout);
    std::vector<ExpectedFrame> frames;
    SourceFrame holds = faulty(20, 15, Fault::kCutFrame, 6);
    holds.holds = true;
    for (const SourceFrame& frame : {holds, good(1, 1), good(9, 15)}) {
      for (const WireLinePtr& line : make_wire_lines(frame)) guard.feed(*line, frames);
    }
    return guard.errors();
  };
  CHECK(errors(0) == 1);
  CHECK(errors(1) == 2);
}

TEST_CASE("sizes that are not legal are dropped, flagged or cut") {
  CHECK(guarded({good(4, 9), good(9, 9)}).frames.size() == 1);
  CHECK(guarded({good(4, 9), good(9, 9)}).kinds == 1u << kTooNarrowEvent);
  CHECK(guarded({good(kMaxWidthPx + 1, 5), good(9, 9)}).kinds == 1u << kTooWideEvent);
  CHECK(guarded({good(kMaxWidthPx, 5)}).errors == 0);
  const Outcome low = guarded({good(9, 4), good(9, 9)});
  CHECK(low.frames[0].end == FrameEnd::kTooLow);
  CHECK(low.kinds == 1u << kTooFewRowsEvent);
  const Outcome tall = guarded({good(5, kMaxHeightPx + 1), good(9, 9)});
  CHECK(tall.frames[0].image.height == kMaxHeightPx);
  CHECK(tall.frames[0].end == FrameEnd::kBadHeight);
  CHECK(tall.kinds == 1u << kTooTallEvent);
}
