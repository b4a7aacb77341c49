// SPDX-License-Identifier: Apache-2.0
#include "sim/simulator.hpp"

#include <string>
#include <utility>

#include "golden/error.hpp"
#include "sim/testbench.hpp"

// libsystemc's own entry point refers to it; the simulator starts SystemC itself.
int sc_main(int, char**) { return 1; }

namespace trihedron::sim {
namespace {

// Lives as long as the process: SystemC has no second elaboration.
Testbench& testbench() {
  static Testbench& bench = *new Testbench("trihedron");
  return bench;
}

void check_gap(const std::optional<SourceFrame>& frame) {
  if (!frame || (frame->gap_clocks >= 0 && frame->gap_clocks <= kMaxGapClocks)) return;
  throw Error("simulation: a gap of " + std::to_string(frame->gap_clocks) +
              " clocks before a frame; right is 0 to " + std::to_string(kMaxGapClocks));
}

void check_shape(const std::optional<SourceFrame>& frame) {
  if (!frame) return;
  const GreyImage& image = frame->image;
  if (image.width > 0 && image.height > 0 &&
      image.pixels.size() == static_cast<std::size_t>(image.width) * image.height) {
    return;
  }
  throw Error("simulation: an image of " + std::to_string(image.width) + " x " +
              std::to_string(image.height) + " px with " + std::to_string(image.pixels.size()) +
              " pixels; right is width * height, at least one");
}

void check_legal(const GreyImage& image) {
  if (image.width >= kMinSizePx && image.width <= kMaxWidthPx && image.height >= kMinSizePx &&
      image.height <= kMaxHeightPx) {
    return;
  }
  throw Error("simulation: an image of " + std::to_string(image.width) + " x " +
              std::to_string(image.height) + " px; right is " + std::to_string(kMinSizePx) +
              " to " + std::to_string(kMaxWidthPx) + " x " + std::to_string(kMinSizePx) + " to " +
              std::to_string(kMaxHeightPx));
}

}  // namespace

#ifdef TRIHEDRON_RTL_COVERAGE
const bool kCountsCodeCoverage = true;
#else
const bool kCountsCodeCoverage = false;
#endif

Simulator::Simulator() { testbench(); }

Simulator& Simulator::instance() {
  static Simulator simulator;
  return simulator;
}

Report Simulator::run(const RunOptions& options, const FrameSource& source, const FrameSink& sink) {
  Testbench& bench = testbench();
  const FrameSource checked = [&source](int view) {
    std::optional<SourceFrame> frame = source(view);
    check_gap(frame);
    check_shape(frame);
    return frame;
  };
  bench.begin(options);
  try {
    bool more = true;
    while (more) {
      more = bench.advance();
      bench.serve(checked);
      for (FrameResult& frame : bench.take_frames()) {
        if (sink) sink(std::move(frame));
      }
    }
  } catch (...) {
    bench.cancel();
    const FrameSource nothing = [](int) { return std::nullopt; };
    // First the views whose request the failure left open: nothing would ever answer them.
    bench.serve(nothing);
    while (bench.advance()) bench.serve(nothing);
    bench.take_frames();
    throw;
  }
  return bench.report();
}

std::vector<ViewFeatures> simulate_views(const std::vector<GreyImage>& views,
                                         const RunOptions& options, Report* report) {
  if (views.empty() || views.size() > kViews) {
    throw Error("simulation: " + std::to_string(views.size()) + " views; right is 1 to " +
                std::to_string(kViews));
  }
  for (const GreyImage& view : views) check_legal(view);
  std::vector<bool> sent(views.size());
  std::vector<ViewFeatures> features(views.size());
  const FrameSource source = [&](int view) -> std::optional<SourceFrame> {
    const auto v = static_cast<std::size_t>(view);
    if (v >= views.size() || sent[v]) return std::nullopt;
    sent[v] = true;
    return SourceFrame{views[v]};
  };
  const Report outcome = Simulator::instance().run(options, source, [&](FrameResult&& frame) {
    features[static_cast<std::size_t>(frame.view)] = std::move(frame.features);
  });
  if (report) *report = outcome;
  if (outcome.mismatch) throw Error("simulation: " + outcome.mismatch->text());
  return features;
}

}  // namespace trihedron::sim
