// SPDX-License-Identifier: Apache-2.0
#include "sim/regression.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/pattern.hpp"
#include "sim/random.hpp"

namespace trihedron::sim {
namespace {

struct Size {
  int width = 0;   ///< px
  int height = 0;  ///< px
};

int frames_per_view(Random& random) { return random.between(1, 5); }

// The extremes are narrow in the other direction: a frame costs about 10,000 clocks at most.
Size random_size(Random& random) {
  switch (random.between(0, 9)) {
    case 0:
      return {kMinSizePx, kMinSizePx};
    case 1:
      return {kMaxWidthPx - random.between(0, 3), random.between(kMinSizePx, 8)};
    case 2:
      return {random.between(kMinSizePx, 8), kMaxHeightPx - random.between(0, 3)};
    case 3:
      return {2 * random.between(3, 60) + 1, 2 * random.between(3, 40) + 1};
    case 4:
    case 5:
      return {random.between(kMinSizePx, 16), random.between(kMinSizePx, 16)};
    default:
      return {random.between(17, 160), random.between(17, 80)};
  }
}

StallProfile random_stalls(Random& random) {
  switch (random.between(0, 4)) {
    case 0:
      return {0.1, 1};
    case 1:
      return {0.5, 1};
    case 2:
      return {0.02, 64};
    default:
      return {};
  }
}

// Either far below the flush timeout, or so far above it that the frame before has ended even
// when back-pressure keeps several lines of it waiting.
int random_gap(const Size& size, const RunOptions& options, Random& random) {
  if (random.chance(0.8)) return random.between(1, 100);
  return 3 * options.flush_timeout + 40 * size.width;
}

void add_fault(SourceFrame& frame, Random& random) {
  GreyImage& image = frame.image;
  frame.fault_line = random.between(0, image.height - 1);
  frame.fault_px = random.between(1, std::max(1, std::min(8, image.width - 1)));
  const int kind = random.between(1, kFaults + 2);
  if (kind < kFaults) {
    frame.fault = static_cast<Fault>(kind);
    return;
  }
  // Sizes that are not legal.
  const int choice = kind - kFaults;
  if (choice == 0) image = make_image(Pattern::kNoise, random.between(1, 4), 6, random, {});
  if (choice == 1) image = make_image(Pattern::kNoise, kMaxWidthPx + 1, 5, random, {});
  if (choice == 2) image = make_image(Pattern::kNoise, 8, random.between(1, 4), random, {});
  frame.fault_line = 0;
}

golden::FrontEndConfig random_thresholds(Random& random) {
  golden::FrontEndConfig config;
  if (random.chance(0.4)) return config;
  config.first_contour.noise_floor = random.between(1, random.chance(0.5) ? 40 : 511);
  config.first_contour.mean_limit = random.between(1, 31);
  config.second_contour.support = random.between(0, random.chance(0.5) ? 400 : 12775);
  config.vertices.branch_floor = random.between(1, random.chance(0.5) ? 60 : 511);
  config.vertices.min_turn = random.between(1, 27);
  return config;
}

// New thresholds in the middle of the frame before the last one, in all views.
void add_change(RegressionCase& result, Random& random) {
  for (std::vector<SourceFrame>& sequence : result.frames) (sequence.end() - 2)->holds = true;
  const int limit = random.chance(0.5) ? kMaxVertexLimit : random.between(0, 20);
  result.options.changes.push_back({random_thresholds(random), limit});
}

}  // namespace

int frames_in_case(std::uint64_t seed) {
  Random random(seed);
  return kViews * frames_per_view(random);
}

RegressionCase make_case(std::uint64_t seed, const std::vector<GreyImage>& pictures) {
  Random random(seed);
  RegressionCase result;
  const int frames = frames_per_view(random);
  RunOptions& options = result.options;
  options.seed = seed;
  options.check = true;
  options.thresholds = random_thresholds(random);
  options.pixel_idles = random_stalls(random);
  options.contour_stalls = random_stalls(random);
  options.vertex_stalls = random_stalls(random);
  options.register_stalls = random_stalls(random);
  const bool same_size = random.chance(0.5);
  const bool known_height = same_size && random.chance(0.5);
  const bool faults = random.chance(0.3);
  const Size common = random_size(random);
  if (known_height) options.frame_height = common.height;
  if (random.chance(0.2)) options.vertex_limit = random.between(0, 20);
  options.flush_timeout = random.between(512, 1500);
  for (std::vector<SourceFrame>& sequence : result.frames) {
    for (int index = 0; index < frames; ++index) {
      const Size size = same_size ? common : random_size(random);
      SourceFrame frame;
      frame.image = make_image(static_cast<Pattern>(random.between(0, kPatterns - 1)), size.width,
                               size.height, random, pictures);
      if (random.chance(0.2)) frame.gap_clocks = random_gap(size, options, random);
      // The last frame is good, so that the one before it ends.
      if (faults && index + 1 < frames && random.chance(0.5)) add_fault(frame, random);
      sequence.push_back(std::move(frame));
    }
  }
  if (!faults && frames > 1 && random.chance(0.4)) add_change(result, random);
  return result;
}

Report run_case(const RegressionCase& regression_case) {
  std::array<std::size_t, kViews> sent{};
  const FrameSource source = [&](int view) -> std::optional<SourceFrame> {
    const auto v = static_cast<std::size_t>(view);
    if (sent[v] == regression_case.frames[v].size()) return std::nullopt;
    return regression_case.frames[v][sent[v]++];
  };
  return Simulator::instance().run(regression_case.options, source, nullptr);
}

}  // namespace trihedron::sim
