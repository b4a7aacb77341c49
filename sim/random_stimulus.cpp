// SPDX-License-Identifier: Apache-2.0
#include "sim/random_stimulus.hpp"

#include <algorithm>

#include "sim/pattern.hpp"

namespace trihedron::sim {

Size random_size(Random& random) {
  // Thousands of vertices in one frame.
  if (random.chance(0.02)) return {random.between(1000, kMaxWidthPx), random.between(13, 80)};
  const int below_largest = random.chance(0.5) ? 0 : random.between(1, 3);
  switch (random.between(0, 13)) {
    case 0:
      return {kMinSizePx, kMinSizePx};
    case 1:
      return {kMaxWidthPx - below_largest, random.between(kMinSizePx, 8)};
    case 2:
      return {random.between(kMinSizePx, 8), kMaxHeightPx - below_largest};
    case 3:
      return {2 * random.between(3, 60) + 1, 2 * random.between(3, 40) + 1};
    case 4:
    case 5:
      return {random.between(kMinSizePx, 16), random.between(kMinSizePx, 16)};
    case 6:
      return {random.between(161, 1000), random.between(kMinSizePx, 12)};
    case 7:
      return {random.between(kMinSizePx, 12), random.between(81, 600)};
    case 8:
      return {random.between(17, 160), kMinSizePx};
    case 9:
      return {kMinSizePx, random.between(17, 160)};
    default:
      return {random.between(17, 160), random.between(17, 80)};
  }
}

StallProfile stalls_of_kind(std::uint64_t kind) {
  switch (kind % kStallKinds) {
    case 0:
      return {0.1, 1};
    case 1:
      return {0.5, 1};
    case 2:
      return {0.02, 64};
    case 3:
      return {0.0005, kLongestStallClocks};
    default:
      return {};
  }
}

StallProfile random_stalls(Random& random) { return stalls_of_kind(random.next()); }

// One of the range's ends, or half of the time up to `usual`, where there is something to decide,
// or anywhere.
static int random_level(int lowest, int usual, int highest, Random& random) {
  const int choice = random.between(0, 9);
  if (choice == 0) return lowest;
  if (choice == 1) return highest;
  return random.between(lowest, choice < 6 ? usual : highest);
}

golden::FrontEndConfig random_thresholds(Random& random) {
  golden::FrontEndConfig config;
  if (random.chance(0.4)) return config;
  config.first_contour.noise_floor = random_level(1, 40, 511, random);
  config.first_contour.mean_limit = random_level(1, 31, 31, random);
  config.second_contour.support = random_level(0, 2000, 12775, random);
  config.vertices.branch_floor = random_level(1, 60, 511, random);
  config.vertices.min_turn = random_level(1, 16, 16, random);
  return config;
}

int random_vertex_limit(Random& random) {
  if (random.chance(0.6)) return kMaxVertexLimit;
  if (random.chance(0.1)) return 0;
  return random.between(0, random.chance(0.7) ? 20 : kMaxVertexLimit);
}

int random_flush_timeout(const StallProfile& pixel_idles, Random& random) {
  if (pixel_idles.probability == 0.0 && random.chance(0.3)) return random.between(16, 64);
  if (random.chance(0.08)) return random.between(5000, 70000);
  // Above the longest pause that a driver makes by itself.
  return random.between(512, 1500) + pixel_idles.longest;
}

int random_gap(const Size& size, const RunOptions& options, Random& random) {
  const int enough = 3 * options.flush_timeout + 40 * size.width +
                     6 * std::max(options.contour_stalls.longest, options.vertex_stalls.longest);
  if (enough > kMaxGapClocks || random.chance(0.7)) {
    return random.between(1, std::min(100, options.flush_timeout / 4));
  }
  return enough;
}

void add_fault(SourceFrame& frame, Random& random) {
  GreyImage& image = frame.image;
  frame.fault_line = random.between(0, image.height - 1);
  frame.fault_px = random.between(1, std::max(1, std::min(8, image.width - 1)));
  const int kind = random.between(1, kFaults + 3);
  if (kind < kFaults) {
    frame.fault = static_cast<Fault>(kind);
    return;
  }
  // Sizes that are not legal.
  const int choice = kind - kFaults;
  // As FRAME_HEIGHT says, where that is not many lines of the widest.
  const int height = std::min(image.height, 12);
  if (choice == 0) image = make_image(Pattern::kNoise, random.between(1, 4), height, random, {});
  if (choice == 1) {
    image = make_image(Pattern::kNoise, kMaxWidthPx + random.between(1, 3), height, random, {});
  }
  if (choice == 2) image = make_image(Pattern::kNoise, 8, random.between(1, 4), random, {});
  if (choice == 3) {
    image = make_image(Pattern::kPolygons, random.between(5, 8),
                       kMaxHeightPx + random.between(1, 3), random, {});
  }
  frame.fault_line = 0;
}

}  // namespace trihedron::sim
