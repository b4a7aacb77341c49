// SPDX-License-Identifier: Apache-2.0
#include "faults/experiment.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

#include "faults/flip_flops.hpp"
#include "golden/front_end.hpp"
#include "golden/registers.hpp"
#include "sim/beats.hpp"
#include "sim/pattern.hpp"
#include "sim/registers.hpp"

namespace trihedron::faults {
namespace {

constexpr int kFrames = 7;       // per view
constexpr int kFollowers = 3;    // whole frames that follow the one with the upset
constexpr int kFreshFrames = 4;  // sent after registers have been written again
constexpr int kFlushTimeout = 64;
// Longer than the flush timeout, a drain of nine rows and the longest stalls together.
constexpr std::uint64_t kPatience = 1200;
// Where the input stands still because the upset hit a width: a drain of eleven rows of the longest
// that a column counter makes, 2048.
constexpr std::uint64_t kWidestDrain = 12 * 2048;

ViewOutput expected_output(const sim::GreyImage& image, int view) {
  const ViewFeatures golden =
      golden::run_front_end(image.pixels.data(), image.width, image.height, image.width);
  ViewOutput output;
  for (const ContourBeat& beat : golden.contour) {
    output.contour.push_back(sim::pack(beat));
    if (output.contour.size() % static_cast<std::size_t>(image.width) == 0) {
      output.contour.back() |= std::uint64_t{1} << 62;
    }
  }
  output.contour.front() |= std::uint64_t{1} << 63;
  for (const Vertex& vertex : golden.vertices) {
    output.records.push_back(sim::pack(vertex) | sim::record_head(sim::kVertexKind, view, 0));
  }
  output.records.push_back(sim::record_head(sim::kEndKind, view, 0) | std::uint64_t{1} << 7 |
                           golden.vertices.size() << 16);
  return output;
}

/// How many frames match, from the first on and from the last back, in both streams.
struct Matching {
  int leading = 0, trailing = 0;
  bool whole = false;  ///< nothing missing, nothing between them
};

template <typename Stream>
Matching match(const std::vector<std::uint64_t>& got, const std::vector<ViewOutput>& frames,
               Stream stream) {
  Matching matching;
  auto front = got.begin();
  for (const ViewOutput& frame : frames) {
    const auto& want = stream(frame);
    if (got.end() - front < static_cast<std::ptrdiff_t>(want.size()) ||
        !std::equal(want.begin(), want.end(), front)) {
      break;
    }
    front += static_cast<std::ptrdiff_t>(want.size());
    ++matching.leading;
  }
  auto back = got.rbegin();
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
    const auto& want = stream(*frame);
    if (got.rend() - back < static_cast<std::ptrdiff_t>(want.size()) ||
        !std::equal(want.rbegin(), want.rend(), back)) {
      break;
    }
    back += static_cast<std::ptrdiff_t>(want.size());
    ++matching.trailing;
  }
  matching.whole = front == got.end() && matching.leading == static_cast<int>(frames.size());
  return matching;
}

Matching match_both(const ViewOutput& got, const std::vector<ViewOutput>& frames) {
  const Matching a = match(got.contour, frames, [](const ViewOutput& f) { return f.contour; });
  const Matching b = match(got.records, frames, [](const ViewOutput& f) { return f.records; });
  return {std::min(a.leading, b.leading), std::min(a.trailing, b.trailing), a.whole && b.whole};
}

bool tags_count_up(const ViewOutput& output) {
  std::uint8_t tag = 0;
  for (std::size_t i = 0; i < output.tags.size(); ++i) {
    if (output.tags[i] != tag) return false;
    tag = static_cast<std::uint8_t>(tag + (output.records[i] >> 7 & 1));
  }
  return true;
}

bool write_registers(StreamBench& bench, const Scene& scene) {
  sim::RunOptions options;
  options.frame_height = scene.frame_height;
  options.flush_timeout = kFlushTimeout;
  std::vector<sim::RegisterValue> settings = sim::run_settings(options);
  settings.push_back({"CONTROL", registers::kControl, registers::kControlEnable.reset});
  for (const sim::RegisterValue& setting : settings) {
    std::uint32_t data = setting.value;
    if (!bench.access(true, setting.address, data)) return false;
  }
  std::uint32_t id = 0;
  return bench.access(false, registers::kId, id) && id == registers::kIdId.reset;
}

void send_all(StreamBench& bench, const Scene& scene, std::size_t first) {
  for (int view = 0; view < sim::kViews; ++view) {
    const auto& frames = scene.views[static_cast<std::size_t>(view)].frames;
    for (std::size_t i = first; i < frames.size(); ++i) bench.send(view, frames[i]);
  }
}

/// The registers are written again, fresh frames are sent: the last two must be right.
Consequence after_repair(StreamBench& bench, const Scene& scene) {
  if (!bench.all_sent() || !write_registers(bench, scene)) return Consequence::kReset;
  bench.run(kPatience, nullptr);
  bench.forget_output();
  send_all(bench, scene, kFrames - kFreshFrames);
  bench.run(kPatience, nullptr);
  for (int view = 0; view < sim::kViews; ++view) {
    const auto& expected = scene.views[static_cast<std::size_t>(view)].expected;
    if (match_both(bench.output(view), {expected.end() - 2, expected.end()}).trailing < 2) {
      return Consequence::kReset;
    }
  }
  return Consequence::kRegisters;
}

std::string sizes(const std::vector<sim::SourceFrame>& frames) {
  std::string text;
  for (const sim::SourceFrame& frame : frames) {
    text += (text.empty() ? "" : ", ") + std::to_string(frame.image.width) + " x " +
            std::to_string(frame.image.height);
  }
  return text;
}

Consequence judge_view(const ViewOutput& got, const std::vector<ViewOutput>& expected,
                       int current) {
  const Matching matching = match_both(got, expected);
  if (matching.whole) {
    return tags_count_up(got) ? Consequence::kMasked : Consequence::kTags;
  }
  const int right_again = kFrames - matching.trailing;  // first frame from which on all is right
  if (matching.trailing == 0) return Consequence::kReset;
  if (right_again > current + 2) return Consequence::kLate;
  const int wrong = right_again - matching.leading;
  if (wrong == 1) return Consequence::kOneFrame;
  return wrong <= 2 ? Consequence::kTwoFrames : Consequence::kMoreFrames;
}

}  // namespace

Scene make_scene(std::uint64_t seed) {
  sim::Random random(seed);
  Scene scene;
  scene.seed = seed;
  const bool known_height = random.chance(0.5);
  const int height = random.between(8, 24);
  if (known_height) scene.frame_height = height;
  for (int view = 0; view < sim::kViews; ++view) {
    Scene::View& sequence = scene.views[static_cast<std::size_t>(view)];
    const bool one_width = random.chance(0.6);
    const int width = random.between(8, 40);
    for (int i = 0; i < kFrames; ++i) {
      sim::SourceFrame frame;
      const auto pattern = random.chance(0.7) ? sim::Pattern::kPolygons : sim::Pattern::kNoise;
      frame.image = sim::make_image(pattern, one_width ? width : random.between(8, 40),
                                    known_height ? height : random.between(8, 24), random, {});
      if (random.chance(0.3)) frame.gap_clocks = random.between(1, kFlushTimeout / 4);
      sequence.expected.push_back(expected_output(frame.image, view));
      sequence.frames.push_back(std::move(frame));
    }
  }
  return scene;
}

Window dry_run(const Scene& scene) {
  StreamBench bench(scene.seed);
  Window window;
  const FlipFlops flip_flops(bench.device());
  for (std::size_t i = 0; i < flip_flops.count(); ++i) {
    if (flip_flops.exists(i)) window.flip_flops.push_back(i);
  }
  if (!write_registers(bench, scene)) throw std::runtime_error("the registers do not answer");
  send_all(bench, scene, 0);
  window.first = bench.clocks();
  bench.run(kPatience, [&](std::uint64_t clock) {
    bool early = true;
    for (int view = 0; view < sim::kViews; ++view) {
      early = early && bench.starts(view) <= kFrames - kFollowers;
    }
    if (early) window.last = clock;
  });
  for (int view = 0; view < sim::kViews; ++view) {
    if (!match_both(bench.output(view), scene.views[static_cast<std::size_t>(view)].expected)
             .whole) {
      throw std::runtime_error("scene " + std::to_string(scene.seed) +
                               " is not right without an upset");
    }
  }
  return window;
}

std::size_t flip_flop_called(const std::string& name) {
  StreamBench bench(0);
  const FlipFlops flip_flops(bench.device());
  const std::size_t index = flip_flops.find(name);
  if (index == flip_flops.count()) throw std::runtime_error("no flip-flop is called " + name);
  return index;
}

Upset run_upset(const Scene& scene, std::uint64_t clock, std::size_t flip_flop) {
  StreamBench bench(scene.seed);
  FlipFlops flip_flops(bench.device());
  Upset upset{scene.seed, clock, flip_flop, flip_flops.name(flip_flop), {}, {}};
  write_registers(bench, scene);
  send_all(bench, scene, 0);
  std::array<int, sim::kViews> current{};
  bench.run(kPatience, [&](std::uint64_t now) {
    if (now != clock) return;
    flip_flops.flip(flip_flop);
    for (int view = 0; view < sim::kViews; ++view) {
      current[static_cast<std::size_t>(view)] = bench.starts(view) - 1;
    }
  });
  if (!bench.all_sent()) bench.run(kWidestDrain, nullptr);
  for (int view = 0; view < sim::kViews; ++view) {
    const auto v = static_cast<std::size_t>(view);
    const Matching matching = match_both(bench.output(view), scene.views[v].expected);
    upset.details += "view " + std::to_string(view) + ": in frame " + std::to_string(current[v]) +
                     ", right: first " + std::to_string(matching.leading) + ", last " +
                     std::to_string(matching.trailing) + " of " + std::to_string(kFrames) + ", " +
                     std::to_string(bench.starts(view)) +
                     " taken; px: " + sizes(scene.views[v].frames) + "\n";
    upset.consequence = std::max(
        upset.consequence, judge_view(bench.output(view), scene.views[v].expected, current[v]));
  }
  std::uint32_t id = 0;
  const bool answers = bench.access(false, registers::kId, id) && id == registers::kIdId.reset;
  if (!answers) upset.consequence = Consequence::kReset;
  if (upset.consequence == Consequence::kReset) upset.consequence = after_repair(bench, scene);
  return upset;
}

}  // namespace trihedron::faults
