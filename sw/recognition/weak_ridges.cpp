// SPDX-License-Identifier: Apache-2.0
#include "recognition/weak_ridges.hpp"

#include <algorithm>
#include <cmath>

namespace trihedron {
namespace {

/// The four averaged magnitudes of pure noise stay below three times their median but for about
/// one pixel in a million.
constexpr int kNoiseFactor = 3;
/// A smooth shade rounded to grey levels has steps of one level, which reach 2: twice that.
constexpr int kMinMagnitude = 4;
/// Two windows of the front end: noise is correlated over one.
constexpr std::size_t kMinRunPx = 10;

class RidgeFinder {
 public:
  RidgeFinder(const ViewFeatures& features, const std::vector<std::uint8_t>& contour)
      : features_(features),
        floor_(std::max(kMinMagnitude, kNoiseFactor * noise_magnitude(features))),
        ridge_(contour.size(), 0) {
    for (int y = 1; y + 1 < features.height; ++y) {
      for (int x = 1; x + 1 < features.width; ++x) {
        const int i = y * features.width + x;
        ridge_[static_cast<std::size_t>(i)] = !contour[static_cast<std::size_t>(i)] && is_ridge(i);
      }
    }
  }

  /// Long enough runs, moved into `contour`.
  void collect(std::vector<std::uint8_t>* contour) {
    for (int i = 0; i < static_cast<int>(ridge_.size()); ++i) {
      if (!ridge_[static_cast<std::size_t>(i)]) continue;
      const std::vector<int> run = take_run(i);
      if (run.size() < kMinRunPx) continue;
      for (const int p : run) (*contour)[static_cast<std::size_t>(p)] = 1;
    }
  }

 private:
  int magnitude(int i) const { return features_.contour[static_cast<std::size_t>(i)].magnitude; }

  /// Across means towards the neighbour nearest to the gradient's direction.
  bool is_ridge(int i) const {
    const ContourBeat& beat = features_.contour[static_cast<std::size_t>(i)];
    if (beat.magnitude < floor_) return false;
    const double largest = std::max(std::abs(beat.gx), std::abs(beat.gy));
    if (largest == 0) return false;
    const int dx = static_cast<int>(std::lround(beat.gx / largest));
    const int dy = static_cast<int>(std::lround(beat.gy / largest));
    const int step = dy * features_.width + dx;
    return beat.magnitude > magnitude(i - step) && beat.magnitude >= magnitude(i + step);
  }

  std::vector<int> take_run(int from) {
    std::vector<int> run = {from};
    ridge_[static_cast<std::size_t>(from)] = 0;
    for (std::size_t n = 0; n < run.size(); ++n) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int q = run[n] + dy * features_.width + dx;  // ridges keep off the border
          if (!ridge_[static_cast<std::size_t>(q)]) continue;
          ridge_[static_cast<std::size_t>(q)] = 0;
          run.push_back(q);
        }
      }
    }
    return run;
  }

  const ViewFeatures& features_;
  int floor_;
  std::vector<std::uint8_t> ridge_;
};

}  // namespace

int noise_magnitude(const ViewFeatures& features) {
  std::vector<std::uint16_t> magnitudes;
  for (const ContourBeat& beat : features.contour) {
    if (!(beat.flags & kFirstContour)) magnitudes.push_back(beat.magnitude);
  }
  if (magnitudes.empty()) return 0;
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  return *middle;
}

void add_weak_ridges(const ViewFeatures& features, std::vector<std::uint8_t>* contour) {
  RidgeFinder(features, *contour).collect(contour);
}

}  // namespace trihedron
