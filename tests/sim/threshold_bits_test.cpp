// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>

#include "golden/front_end.hpp"
#include "sim/test_frames.hpp"

using namespace trihedron;
using namespace trihedron::sim;

namespace {

golden::FrontEndConfig with_support(int support) {
  golden::FrontEndConfig config;
  config.first_contour = {1, 31};
  config.second_contour.support = support;
  return config;
}

std::ptrdiff_t contour_px(const GreyImage& image, int support) {
  const golden::FrontEndConfig config = with_support(support);
  const ViewFeatures features =
      golden::run_front_end(image.pixels.data(), image.width, image.height, image.width, config);
  return std::count_if(features.contour.begin(), features.contour.end(),
                       [](const ContourBeat& beat) { return (beat.flags & 1u) != 0; });
}

}  // namespace

// Sums of noise of black and white lie close enough to tell a threshold from one with a single bit
// changed.
TEST_CASE("a high SUPPORT is compared in all its bits") {
  constexpr int kSupport = 4096 + 512, kBits = 14;
  constexpr int kLeastBit = 2;  // below, no sum of this image need lie between the two
  Random random(11);
  const GreyImage noise = make_image(Pattern::kSaturated, 200, 160, random, {});
  for (int bit = kLeastBit; bit < kBits; ++bit) {
    CAPTURE(bit);
    REQUIRE(contour_px(noise, kSupport) != contour_px(noise, kSupport ^ 1 << bit));
  }
  RunOptions options;
  options.check = true;
  options.thresholds = with_support(kSupport);
  REQUIRE(Simulator::instance().run(options, for_all_views({frame_of(noise)}), nullptr).passed());
}
