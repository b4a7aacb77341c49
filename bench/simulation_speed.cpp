// SPDX-License-Identifier: Apache-2.0
// How much of a bare Verilated loop's speed the SystemC testbench keeps, on the same device, frames
// and process, and how many times faster it is than Icarus on the same RTL and frame, outputs
// compared in both. CPU time, runs in turn, best of each: other load on the machine and changes of
// its clock hit all alike. Prints two lines; exit code 1 below a promised ratio.
#include "sim/device.hpp"  // Verilated headers before SystemC's

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <optional>
#include <vector>

#include "bench/simulation_speed_icarus.hpp"
#include "sim/pattern.hpp"
#include "sim/simulator.hpp"

namespace {

using namespace trihedron::sim;

constexpr double kPromisedRatio = 0.8, kPromisedToIcarus = 50;
constexpr int kWidth = 450, kHeight = 300, kFrames = 2, kRounds = 5;
// Icarus takes some ten seconds for this; more frames of it for the others.
constexpr int kSmallWidth = 120, kSmallHeight = 80, kSmallFrames = 28;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Speed {
  double clocks_per_second = 0.0;
  void keep_best(double clocks, double seconds) {
    clocks_per_second = std::max(clocks_per_second, clocks / seconds);
  }
};

/// The least that simulates `image` on all views: inputs, two evals a clock, a beat counter.
std::uint64_t run_bare(const GreyImage& image, std::size_t frames, std::uint64_t& beats) {
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
  const auto width = static_cast<std::size_t>(image.width);
  std::uint64_t clocks = 0;
  top.s_axis_tvalid = 7;
  for (std::size_t at = 0; at < image.pixels.size() * frames; ++clocks) {
    const std::size_t pixel = at % image.pixels.size();
    top.s_axis_tdata = image.pixels[pixel] * 0x10101u;
    top.s_axis_tuser = pixel == 0 ? 7 : 0;
    top.s_axis_tlast = pixel % width == width - 1 ? 7 : 0;
    at += clock();
  }
  return clocks;
}

std::uint64_t run_bench(const GreyImage& image, int frames, bool check) {
  int sent[kViews] = {};
  RunOptions options;
  options.check = check;
  options.frame_height = image.height;
  const FrameSource source = [&](int view) -> std::optional<SourceFrame> {
    if (sent[view]++ == frames) return std::nullopt;
    SourceFrame frame;
    frame.image = image;
    return frame;
  };
  return Simulator::instance().run(options, source, nullptr).clocks;
}

GreyImage polygons(int width, int height) {
  Random random(1);
  return make_image(Pattern::kPolygons, width, height, random, {});
}

double mega(double clocks_per_second) { return clocks_per_second / 1e6; }

bool keeps_the_bare_loops_speed() {
  const GreyImage image = polygons(kWidth, kHeight);
  Speed bare, bench, checked;
  std::uint64_t beats = 0;
  for (int round = 0; round < kRounds; ++round) {
    const double start = cpu_seconds();
    const auto bare_clocks = static_cast<double>(run_bare(image, kFrames, beats));
    const double after_bare = cpu_seconds();
    const auto bench_clocks = static_cast<double>(run_bench(image, kFrames, false));
    const double after_bench = cpu_seconds();
    const auto checked_clocks = static_cast<double>(run_bench(image, kFrames, true));
    bare.keep_best(bare_clocks, after_bare - start);
    bench.keep_best(bench_clocks, after_bench - after_bare);
    checked.keep_best(checked_clocks, cpu_seconds() - after_bench);
  }
  const double ratio = bench.clocks_per_second / bare.clocks_per_second;
  std::printf(
      "bare loop %.3f Mclk/s, SystemC testbench %.3f Mclk/s, with golden check %.3f Mclk/s; "
      "ratios %.2f and %.2f\n",
      mega(bare.clocks_per_second), mega(bench.clocks_per_second), mega(checked.clocks_per_second),
      ratio, checked.clocks_per_second / bare.clocks_per_second);
  return beats > 0 && ratio >= kPromisedRatio;
}

bool leaves_icarus_behind() {
  const GreyImage image = polygons(kSmallWidth, kSmallHeight);
  Speed before, icarus, after;
  const auto measure = [&image](Speed& speed) {
    const double start = cpu_seconds();
    const auto clocks = static_cast<double>(run_bench(image, kSmallFrames, true));
    speed.keep_best(clocks, cpu_seconds() - start);
  };
  measure(before);
  icarus.clocks_per_second = trihedron::bench::icarus_clocks_per_second(image);
  measure(after);
  const double ratio =
      std::min(before.clocks_per_second, after.clocks_per_second) / icarus.clocks_per_second;
  std::printf(
      "Icarus %.4f Mclk/s on %d x %d px, testbench with golden check %.3f Mclk/s; ratio %.0f\n",
      mega(icarus.clocks_per_second), kSmallWidth, kSmallHeight,
      mega(std::min(before.clocks_per_second, after.clocks_per_second)), ratio);
  return ratio >= kPromisedToIcarus;
}

}  // namespace

int main() {
  try {
    const bool fast = keeps_the_bare_loops_speed();
    return leaves_icarus_behind() && fast ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "simulation_speed: %s\n", error.what());
    return 2;
  }
}
