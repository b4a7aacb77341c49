// SPDX-License-Identifier: Apache-2.0
#include "sim/regression.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/functional_coverage.hpp"
#include "sim/pattern.hpp"
#include "sim/random.hpp"
#include "sim/random_stimulus.hpp"

namespace trihedron::sim {
namespace {

// Few, or so many that the frame tag, 8 bits, wraps around: one seed in 200, so that a run of as
// many has one of them.
constexpr int kFewFrames = 5;
bool has_many_frames(std::uint64_t seed) { return seed % 200 == 100; }

// What must meet goes by the seed's digits to the base 3, 6, 6: some hundred seeds in a row have
// broken frames with each kind of stall, and both outputs with all pairs of stalls.
bool has_faults(std::uint64_t seed) { return seed % 3 == 1 || has_many_frames(seed); }
StallProfile contour_stalls(std::uint64_t seed) { return stalls_of_kind(seed / 3); }
StallProfile vertex_stalls(std::uint64_t seed) { return stalls_of_kind(seed / 3 / kStallKinds); }

int frames_per_view(std::uint64_t seed, Random& random) {
  if (has_many_frames(seed)) return random.between(257, 280);
  return random.between(has_faults(seed) ? 3 : 1, kFewFrames);
}

/// Draws one case, part by part; the order of the parts is what a seed means.
class CaseWriter {
 public:
  CaseWriter(std::uint64_t seed, const std::vector<GreyImage>& pictures)
      : random_(seed),
        pictures_(pictures),
        frames_(frames_per_view(seed, random_)),
        many_(has_many_frames(seed)),
        faults_(has_faults(seed)) {
    result_.options.seed = seed;
    result_.options.check = true;
  }

  RegressionCase write() {
    draw_options();
    draw_changes();
    for (std::size_t view = 0; view < kViews; ++view) {
      for (int index = 0; index < frames_; ++index) {
        const auto content = static_cast<Pattern>(random_.between(0, kPatterns - 1));
        result_.contents[view].push_back(content);
        result_.frames[view].push_back(draw_frame(index, content));
      }
    }
    return std::move(result_);
  }

 private:
  void draw_options() {
    RunOptions& options = result_.options;
    options.thresholds = random_thresholds(random_);
    options.vertex_limit = random_vertex_limit(random_);
    options.pixel_idles = random_stalls(random_);
    options.contour_stalls = contour_stalls(options.seed);
    options.vertex_stalls = vertex_stalls(options.seed);
    options.register_stalls = random_stalls(random_);
    options.flush_timeout = random_flush_timeout(options.pixel_idles, random_);
    if (random_.chance(0.15)) options.prelude_clocks = random_.between(1, 3000);
    options.exercise_registers = random_.chance(0.3);
    options.poll_registers = random_.chance(0.3);
    same_size_ = many_ || random_.chance(faults_ ? 0.8 : 0.5);
    common_ = draw_size();
    if (same_size_ && random_.chance(faults_ ? 0.8 : 0.5)) options.frame_height = known_height();
  }

  // Lower: lines are left over; higher: each next frame starts too early. Both meet broken frames.
  int known_height() {
    if (random_.chance(faults_ ? 0.3 : 0.6)) return common_.height;
    const int off = random_.chance(0.5) ? random_.between(-3, -1) : random_.between(1, 3);
    return std::clamp(common_.height + off, kMinSizePx, kMaxHeightPx);
  }

  void draw_changes() {
    const bool wanted = many_ || random_.chance(0.4);
    int height = result_.options.frame_height;
    for (int index = 0; index < frames_; ++index) {
      heights_.push_back(height);
      holds_.push_back(wanted && index + 1 < frames_ && random_.chance(many_ ? 0.3 : 0.6));
      if (!holds_.back()) continue;
      SettingsChange change;
      change.thresholds = random_thresholds(random_);
      change.vertex_limit = random_vertex_limit(random_);
      change.held = random_.chance(0.25);
      change.frame_height = height;
      if (same_size_ && random_.chance(0.3)) {
        change.frame_height = height == 0 ? known_height() : 0;
      }
      if (!change.held) height = change.frame_height;
      if (random_.chance(0.3)) change.enabled = static_cast<unsigned>(random_.between(0, 7));
      result_.options.changes.push_back(change);
    }
  }

  Size draw_size() {
    if (!many_) return random_size(random_);
    return {random_.between(kMinSizePx, 12), random_.between(kMinSizePx, 12)};
  }

  SourceFrame draw_frame(int index, Pattern content) {
    Size size = same_size_ ? common_ : draw_size();
    const auto at = static_cast<std::size_t>(index);
    const bool last = index + 1 == frames_;
    // The last frame ends by itself.
    if (last) size.height = std::max(size.height, heights_[at]);
    SourceFrame frame;
    frame.image = make_image(content, size.width, size.height, random_, pictures_);
    frame.holds = holds_[at];
    if (random_.chance(0.2)) frame.gap_clocks = random_gap(size, result_.options, random_);
    // The last frame is good, so that the one before it ends; one that holds ends well.
    if (faults_ && !last && !frame.holds && random_.chance(0.6)) add_fault(frame, random_);
    return frame;
  }

  Random random_;
  const std::vector<GreyImage>& pictures_;
  int frames_;
  bool many_;  ///< with every kind of broken frame and change among them
  bool faults_;
  bool same_size_ = false;
  Size common_;
  std::vector<int> heights_;  ///< FRAME_HEIGHT that each frame finds
  std::vector<bool> holds_;
  RegressionCase result_;
};

}  // namespace

int frames_in_case(std::uint64_t seed) {
  Random random(seed);
  return kViews * frames_per_view(seed, random);
}

RegressionCase make_case(std::uint64_t seed, const std::vector<GreyImage>& pictures) {
  return CaseWriter(seed, pictures).write();
}

Report run_case(const RegressionCase& regression_case, FunctionalCoverage* coverage) {
  std::array<std::size_t, kViews> sent{};
  const FrameSource source = [&](int view) -> std::optional<SourceFrame> {
    const auto v = static_cast<std::size_t>(view);
    if (sent[v] == regression_case.frames[v].size()) return std::nullopt;
    return regression_case.frames[v][sent[v]++];
  };
  std::vector<FrameResult> frames;
  const FrameSink sink = [&](FrameResult&& frame) {
    if (coverage) frames.push_back(std::move(frame));
  };
  const Report report = Simulator::instance().run(regression_case.options, source, sink);
  if (coverage && report.passed()) {
    coverage->sample(regression_case, report);
    for (const FrameResult& frame : frames) coverage->sample(frame);
  }
  return report;
}

}  // namespace trihedron::sim
