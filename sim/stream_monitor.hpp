// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "sim/random.hpp"

namespace trihedron::sim {

/// One line of contour beats as it left the hardware: the transaction between monitor and
/// scoreboard.
struct ContourLine {
  std::vector<std::uint64_t> beats;  ///< as packed on the stream
  bool start = false;                ///< tuser at the first beat
  int stray_start = -1;              ///< column of a tuser elsewhere, or -1
  bool end = true;                   ///< false: cut by the monitor, no tlast within kMaxWidthPx
  std::uint64_t first_clock = 0;     ///< clock of the first beat
  std::uint64_t last_clock = 0;      ///< clock of the last beat
  std::uint64_t stalls = 0;          ///< clocks with a beat offered but not taken, since the last line
};
using ContourLinePtr = std::shared_ptr<const ContourLine>;

/// A few vertex-stream records of one view, in order. Bit 64 is the tlast that came with each.
struct VertexRecord {
  std::uint64_t data = 0;
  bool last = false;
};
using VertexBurst = std::shared_ptr<const std::vector<VertexRecord>>;

/// The handshake rules of a stream's sender: once valid, a beat stays valid and unchanged until
/// it is taken (AMBA AXI4-Stream, section 2.2).
class HandshakeRule {
 public:
  /// True when the rule is kept at this clock.
  bool keep(bool valid, bool ready, std::uint64_t data, unsigned flags) {
    const bool kept = !stalled_ || (valid && data == data_ && flags == flags_);
    stalled_ = valid && !ready;
    data_ = data;
    flags_ = flags;
    return kept;
  }

 private:
  bool stalled_ = false;
  std::uint64_t data_ = 0;
  unsigned flags_ = 0;
};

/// Receiver of one view's contour stream: random back-pressure, protocol check, beats to lines.
class ContourMonitor {
 public:
  ContourMonitor(const StallProfile& stalls, std::uint64_t seed) : stall_(stalls, seed) {}

  bool ready() { return ready_ = !stall_.at_this_clock(); }

  /// One clock of the stream. Returns false when the sender broke the protocol.
  bool sample(bool valid, std::uint64_t data, bool user, bool last, std::uint64_t clock) {
    if (!rule_.keep(valid, ready_, data, user + 2u * last)) return false;
    if (!valid) return true;
    if (!ready_) {
      ++stalls_;
      return true;
    }
    ++beats_;
    if (!line_)
      open_line(user, clock);
    else if (user)
      line_->stray_start = static_cast<int>(line_->beats.size());
    line_->beats.push_back(data);
    if (last || line_->beats.size() > kMaxWidthPx) close_line(last, clock);
    return true;
  }

  std::vector<ContourLinePtr> take_lines() { return std::exchange(lines_, {}); }
  std::uint64_t beats() const { return beats_; }
  std::uint64_t stalls() const { return stalls_; }

 private:
  void open_line(bool start, std::uint64_t clock) {
    line_ = std::make_shared<ContourLine>();
    line_->beats.reserve(width_);
    line_->start = start;
    line_->first_clock = clock;
  }
  void close_line(bool end, std::uint64_t clock) {
    line_->end = end;
    line_->last_clock = clock;
    line_->stalls = stalls_ - std::exchange(stalls_before_, stalls_);
    width_ = line_->beats.size();
    lines_.push_back(std::move(line_));
    line_ = nullptr;
  }

  Stall stall_;
  HandshakeRule rule_;
  bool ready_ = false;
  std::size_t width_ = 0;
  std::shared_ptr<ContourLine> line_;
  std::vector<ContourLinePtr> lines_;
  std::uint64_t beats_ = 0;
  std::uint64_t stalls_ = 0, stalls_before_ = 0;
};

/// Receiver of the merged vertex stream; sorts the records by view.
class VertexMonitor {
 public:
  VertexMonitor(const StallProfile& stalls, std::uint64_t seed) : stall_(stalls, seed) {}

  bool ready() { return ready_ = !stall_.at_this_clock(); }

  /// One clock of the stream. Returns false when the sender broke the protocol or named a view
  /// that does not exist.
  bool sample(bool valid, std::uint64_t data, bool last) {
    if (!rule_.keep(valid, ready_, data, last)) return false;
    if (!valid || !ready_) return true;
    ++records_taken_;
    const std::size_t view = (data >> 2) & 15;
    if (view >= kViews) return false;
    records_[view].push_back({data, last});
    return true;
  }

  std::vector<VertexRecord> take_records(int view) {
    return std::exchange(records_[static_cast<std::size_t>(view)], {});
  }
  std::uint64_t records_taken() const { return records_taken_; }

 private:
  Stall stall_;
  HandshakeRule rule_;
  bool ready_ = false;
  std::array<std::vector<VertexRecord>, kViews> records_;
  std::uint64_t records_taken_ = 0;
};

}  // namespace trihedron::sim
