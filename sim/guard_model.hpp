// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sim/stimulus.hpp"
#include "sim/wire_line.hpp"

namespace trihedron::sim {

/// How a frame ended: bits of the status in its end-of-frame record.
enum class FrameEnd : std::uint16_t {
  kClean = 0,
  kBadLine = 1,    ///< cut: a line of other width than the first, or a start of frame inside a line
  kBadHeight = 2,  ///< cut: too tall, or started anew before FRAME_HEIGHT lines
  kTooLow = 4,     ///< fewer than 5 lines
};
constexpr std::uint16_t kVerticesLost = 8;  ///< the record's fourth status bit

/// Bad things that the hardware counts, in the order of its event bits.
enum GuardEvent {
  kShortLineEvent,
  kLongLineEvent,
  kTooWideEvent,
  kTooNarrowEvent,
  kTooTallEvent,
  kNoStartEvent,
  kEarlyStartEvent,
  kTooFewRowsEvent,
  kGuardEvents
};

/// A frame that the hardware is to let through: the whole good lines of a sent frame.
struct ExpectedFrame {
  GreyImage image;
  FrameEnd end = FrameEnd::kClean;
  std::size_t start_index = 0;  ///< which of the sent starts of frame began it
  std::size_t changes = 0;      ///< threshold changes before it
};

/// What registers say about a view's frames that start from now on.
struct GuardSettings {
  int frame_height = 0;  ///< lines that end a frame; if 0, idle clocks do
  bool enabled = true;
  int thresholds = 0;  ///< another number, other thresholds or VERTEX_LIMIT: the next start waits
};

/// Which frames come out of any stream of pixels: the rules of rtl/frame_guard.sv without its
/// clocks. Time enters only as gaps between lines, which are either far shorter or far longer
/// than the flush timeout.
class GuardModel {
 public:
  using Settings = GuardSettings;

  /// `settings` at first, after the first line that holds, after the second, ...; a frame of
  /// unknown height is ended by `flush_timeout` idle clocks.
  explicit GuardModel(std::vector<Settings> settings = {{}}, int flush_timeout = 0)
      : settings_(std::move(settings)), flush_timeout_(flush_timeout) {}

  /// The stream goes on with `line`. Appends the frames that this ended to `done`.
  void feed(const WireLine& line, std::vector<ExpectedFrame>& done);

  /// Nothing follows: the input stays idle.
  void finish(std::vector<ExpectedFrame>& done);

  /// Starts of frame so far, and of how many the frames have ended or been dropped, oldest first.
  std::size_t starts() const { return starts_; }
  std::size_t settled_starts() const { return active_ ? starts_ - 1 : starts_; }
  /// One bit per kind of event that happened.
  std::uint32_t event_kinds() const { return event_kinds_; }
  /// Pixels that brought an event; one that brought two counts once, or twice where it waited
  /// between them for new settings.
  std::uint32_t errors() const { return errors_; }

 private:
  void start(std::vector<ExpectedFrame>& done);
  void pixels(const std::uint8_t* first, const std::uint8_t* last, bool start, bool end,
              std::vector<ExpectedFrame>& done);
  void end_line(std::vector<ExpectedFrame>& done);
  void overflow(std::vector<ExpectedFrame>& done);
  void note(GuardEvent event, bool counts = true);
  void end_frame(FrameEnd how, std::vector<ExpectedFrame>& done);
  FrameEnd clean_end() const;
  bool too_tall() const { return frame_.image.height == kMaxHeightPx; }

  std::vector<Settings> settings_;
  int flush_timeout_;
  int frame_height_ = 0;  ///< of the frame that started last
  // Between a start of frame and the frame's end or first fault: active. Its first line was good:
  // begun. The rest of a faulty frame is dropped without further notice: quiet.
  bool active_ = false;
  bool begun_ = false;
  bool quiet_ = false;
  std::vector<std::uint8_t> line_;  ///< so far
  ExpectedFrame frame_;
  std::size_t starts_ = 0;
  std::size_t changes_ = 0;
  bool start_counted_ = false;  ///< the last start of frame brought an event when it was taken
  int thresholds_ = 0;          ///< in force
  std::uint32_t event_kinds_ = 0;
  std::uint32_t errors_ = 0;
};

}  // namespace trihedron::sim
