// SPDX-License-Identifier: Apache-2.0
#include "sim/guard_model.hpp"

#include <algorithm>
#include <utility>

namespace trihedron::sim {

void GuardModel::feed(const WireLine& line, std::vector<ExpectedFrame>& done) {
  if (line.gap_clocks > flush_timeout_ && line_.empty()) finish(done);
  const std::uint8_t* const first = line.pixels.data();
  const std::uint8_t* const last = first + line.pixels.size();
  if (line.stray_start <= 0) {
    pixels(first, last, line.start || line.stray_start == 0, line.end, done);
  } else {
    pixels(first, first + line.stray_start, line.start, false, done);
    pixels(first + line.stray_start, last, true, line.end, done);
  }
  changes_ += line.hold;
}

void GuardModel::finish(std::vector<ExpectedFrame>& done) {
  if (frame_height_ != 0 || !active_ || !begun_ || !line_.empty()) return;
  end_frame(clean_end(), done);
  quiet_ = false;
}

// A run of pixels that has its start of frame, if any, at its first and its end of line, if any,
// at its last pixel.
void GuardModel::pixels(const std::uint8_t* first, const std::uint8_t* last, bool start_here,
                        bool end, std::vector<ExpectedFrame>& done) {
  if (start_here) start(done);
  if (!active_) {
    if (!quiet_) note(kNoStartEvent);
    quiet_ = true;
    return;
  }
  const int limit = begun_ ? frame_.image.width : kMaxWidthPx;
  const auto room = static_cast<std::ptrdiff_t>(limit) - static_cast<std::ptrdiff_t>(line_.size());
  const std::uint8_t* const stop = first + std::min<std::ptrdiff_t>(last - first, room);
  line_.insert(line_.end(), first, stop);
  if (stop < last || (static_cast<int>(line_.size()) == limit && !end)) return overflow(done);
  if (end) end_line(done);
}

void GuardModel::start(std::vector<ExpectedFrame>& done) {
  const std::uint32_t errors_before = errors_;
  if (active_ && (!line_.empty() || frame_height_ != 0)) note(kEarlyStartEvent);
  if (active_) {
    const bool in_line = !line_.empty();
    if (begun_) {
      end_frame(in_line              ? FrameEnd::kBadLine
                : frame_height_ != 0 ? FrameEnd::kBadHeight
                                     : clean_end(),
                done);
    }
  }
  const Settings& settings = settings_.at(std::min(changes_, settings_.size() - 1));
  frame_height_ = settings.frame_height;
  // A start that waits for settings ends the frame before when it comes, not when it is taken.
  const bool waited = std::exchange(thresholds_, settings.thresholds) != settings.thresholds;
  start_counted_ = errors_ != errors_before && !waited;
  active_ = settings.enabled;
  quiet_ = true;
  begun_ = false;
  line_.clear();
  frame_ = ExpectedFrame{};
  frame_.start_index = starts_++;
  frame_.changes = changes_;
}

void GuardModel::end_line(std::vector<ExpectedFrame>& done) {
  GreyImage& image = frame_.image;
  const int width = static_cast<int>(line_.size());
  if (begun_ && (width != image.width || too_tall())) {
    note(width != image.width ? kShortLineEvent : kTooTallEvent);
    return end_frame(too_tall() ? FrameEnd::kBadHeight : FrameEnd::kBadLine, done);
  }
  if (!begun_ && width < kMinSizePx) {
    note(kTooNarrowEvent, width > 1 || !start_counted_);
    active_ = false;
    line_.clear();
    return;
  }
  image.width = width;
  image.pixels.insert(image.pixels.end(), line_.begin(), line_.end());
  ++image.height;
  begun_ = true;
  line_.clear();
  if (image.height != frame_height_) return;
  end_frame(clean_end(), done);
  quiet_ = false;
}

void GuardModel::overflow(std::vector<ExpectedFrame>& done) {
  note(begun_ ? kLongLineEvent : kTooWideEvent);
  if (begun_) end_frame(too_tall() ? FrameEnd::kBadHeight : FrameEnd::kBadLine, done);
  active_ = false;
  line_.clear();
}

void GuardModel::note(GuardEvent event, bool counts) {
  event_kinds_ |= 1u << event;
  errors_ += counts;
}

void GuardModel::end_frame(FrameEnd how, std::vector<ExpectedFrame>& done) {
  frame_.end = how;
  if (how == FrameEnd::kTooLow) note(kTooFewRowsEvent);
  done.push_back(std::exchange(frame_, {}));
  active_ = begun_ = false;
  line_.clear();
}

FrameEnd GuardModel::clean_end() const {
  return frame_.image.height < kMinSizePx ? FrameEnd::kTooLow : FrameEnd::kClean;
}

}  // namespace trihedron::sim
