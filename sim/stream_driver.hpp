// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <utility>

#include "sim/random.hpp"
#include "sim/wire_line.hpp"

namespace trihedron::sim {

/// AXI4-Stream video source of one view at the pins, one call of present() and of accept() a
/// clock. Plays queued lines with random idles; an offered pixel stays until it is accepted.
class StreamDriver {
 public:
  StreamDriver(const StallProfile& idles, std::uint64_t seed) : idle_(idles, seed), noise_(seed) {}

  void queue(WireLinePtr line) { lines_.push_back(std::move(line)); }
  void close() { closed_ = true; }

  /// True when it could offer nothing although more lines are to come: the host must act first.
  bool starving() const { return lines_.empty() && !closed_; }
  bool wants_lines() const { return lines_.size() < kQueueLines && !closed_; }
  /// True when it waits within a line until release().
  bool holding() const {
    return !lines_.empty() && lines_.front()->hold && column_ == kHoldColumn && !released_;
  }
  void release() { released_ = true; }
  bool finished() const { return lines_.empty() && closed_; }

  /// Decides what stands at the pins at this clock.
  void present() {
    if (offering_) return;
    scramble();
    if (lines_.empty()) return;
    const WireLine& line = *lines_.front();
    if (column_ == 0 && gap_ < line.gap_clocks) {
      ++gap_;
      return;
    }
    if (holding() || idle_.at_this_clock()) return;
    offering_ = true;
    data_ = line.pixels[column_];
    user_ = (column_ == 0 && line.start) || static_cast<int>(column_) == line.stray_start;
    last_ = line.end && column_ + 1 == line.pixels.size();
  }

  /// The offered pixel was accepted. Returns true when it was a start of frame.
  bool accept() {
    offering_ = false;
    const WireLine& line = *lines_.front();
    if (++column_ == line.pixels.size()) {
      lines_.pop_front();
      column_ = 0;
      gap_ = 0;
      released_ = false;
    }
    return user_;
  }

  bool valid() const { return offering_; }
  /// Anything while not valid().
  std::uint8_t data() const { return data_; }
  bool user() const { return user_; }
  bool last() const { return last_; }

 private:
  static constexpr std::size_t kQueueLines = 64;
  // The device's input register holds two pixels: when the third is in, the first has left it.
  static constexpr std::size_t kHoldColumn = 3;

  // While nothing is offered the payload means nothing, so it is anything. (Constants: Knuth's
  // MMIX.)
  void scramble() {
    noise_ = noise_ * 6364136223846793005u + 1442695040888963407u;
    data_ = static_cast<std::uint8_t>(noise_ >> 56);
    user_ = (noise_ >> 55 & 1) != 0;
    last_ = (noise_ >> 54 & 1) != 0;
  }

  Stall idle_;
  std::uint64_t noise_;
  std::deque<WireLinePtr> lines_;
  std::size_t column_ = 0;
  int gap_ = 0;
  bool closed_ = false;
  bool released_ = false;
  bool offering_ = false;
  std::uint8_t data_ = 0;
  bool user_ = false;
  bool last_ = false;
};

}  // namespace trihedron::sim
