// SPDX-License-Identifier: Apache-2.0
// How much of a bare Verilated loop's speed the SystemC testbench keeps, on the same device, frames
// and process. CPU time, runs of both in turn, best of each: other load on the machine and changes
// of its clock hit both alike. Prints one line; exit code 1 below the promised ratio.
#include "sim/device.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <optional>
#include <vector>

#include "sim/pattern.hpp"
#include "sim/simulator.hpp"

namespace {

using namespace trihedron::sim;

constexpr double kPromisedRatio = 0.8;
constexpr int kWidth = 450, kHeight = 300, kFrames = 2, kRounds = 5;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Speed {
  double clocks_per_second = 0.0;
  void keep_best(double clocks, double seconds) {
    clocks_per_second = std::max(clocks_per_second, clocks / seconds);
  }
};

/// The least that simulates `image` on all views: inputs, two evals a clock, a beat counter.
std::uint64_t run_bare(const GreyImage& image, std::uint64_t& beats) {
  Device device("");
  Vtrihedron_top& top = device.pins();
  const auto clock = [&] {
    device.settle();
    const bool accepted = top.s_axis_tready == 7;
    beats += top.m_axis_contour_tvalid == 7;
    device.tick();
    return accepted;
  };
  top.m_axis_contour_tready = 7;
  top.m_axis_vertex_tready = 1;
  top.rst_ni = 0;
  for (int i = 0; i < 8; ++i) clock();
  top.rst_ni = 1;
  std::uint64_t clocks = 0;
  top.s_axis_tvalid = 7;
  for (std::size_t at = 0; at < image.pixels.size() * kFrames; ++clocks) {
    const std::size_t pixel = at % image.pixels.size();
    top.s_axis_tdata = image.pixels[pixel] * 0x10101u;
    top.s_axis_tuser = pixel == 0 ? 7 : 0;
    top.s_axis_tlast = pixel % kWidth == kWidth - 1 ? 7 : 0;
    at += clock();
  }
  return clocks;
}

std::uint64_t run_bench(const GreyImage& image, bool check) {
  int sent[kViews] = {};
  RunOptions options;
  options.check = check;
  options.frame_height = kHeight;
  const FrameSource source = [&](int view) -> std::optional<SourceFrame> {
    if (sent[view]++ == kFrames) return std::nullopt;
    SourceFrame frame;
    frame.image = image;
    return frame;
  };
  return Simulator::instance().run(options, source, nullptr).clocks;
}

}  // namespace

int main() {
  Random random(1);
  const GreyImage image = make_image(Pattern::kPolygons, kWidth, kHeight, random, {});
  Speed bare, bench, checked;
  std::uint64_t beats = 0;
  for (int round = 0; round < kRounds; ++round) {
    const double start = cpu_seconds();
    const auto bare_clocks = static_cast<double>(run_bare(image, beats));
    const double after_bare = cpu_seconds();
    const auto bench_clocks = static_cast<double>(run_bench(image, false));
    const double after_bench = cpu_seconds();
    const auto checked_clocks = static_cast<double>(run_bench(image, true));
    bare.keep_best(bare_clocks, after_bare - start);
    bench.keep_best(bench_clocks, after_bench - after_bare);
    checked.keep_best(checked_clocks, cpu_seconds() - after_bench);
  }
  const double ratio = bench.clocks_per_second / bare.clocks_per_second;
  std::printf(
      "bare loop %.3f Mclk/s, SystemC testbench %.3f Mclk/s, with golden check %.3f Mclk/s; "
      "ratios %.2f and %.2f\n",
      bare.clocks_per_second / 1e6, bench.clocks_per_second / 1e6, checked.clocks_per_second / 1e6,
      ratio, checked.clocks_per_second / bare.clocks_per_second);
  return beats > 0 && ratio >= kPromisedRatio ? 0 : 1;
}
