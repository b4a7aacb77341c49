// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <systemc>
#include <utility>

#include "sim/guard_model.hpp"
#include "sim/wire_line.hpp"

namespace trihedron::sim {

/// The caller's side of frame delivery: a SystemC process asks here, the simulation pauses, and
/// the caller's own code runs outside of SystemC, on its own stack.
class FrameDesk {
 public:
  /// Called by SystemC processes.
  std::optional<SourceFrame> request(std::size_t view) {
    asked_[view] = true;
    sc_core::sc_pause();
    sc_core::wait(answered_[view]);
    return std::exchange(frames_[view], std::nullopt);
  }
  bool asked() const { return std::find(asked_.begin(), asked_.end(), true) != asked_.end(); }
  /// Called between two stretches of simulation: answers every request with `source`.
  void serve(const FrameSource& source) {
    for (std::size_t view = 0; view < kViews; ++view) {
      if (!asked_[view]) continue;
      asked_[view] = false;
      answered_[view].notify(sc_core::SC_ZERO_TIME);
      frames_[view] = source(static_cast<int>(view));
    }
  }

 private:
  std::array<bool, kViews> asked_{};
  std::array<sc_core::sc_event, kViews> answered_;
  std::array<std::optional<SourceFrame>, kViews> frames_;
};

/// Turns one view's frames into lines for its driver and tells what is expected to come out.
/// Works ahead of the driver, so that an expectation is known before its frame is sent: by one
/// frame, or by as many as run together because their starts are missing.
class FrameSourceProcess : public sc_core::sc_module {
 public:
  using Expect = std::function<void(ExpectedFrame&&)>;

  sc_core::sc_fifo_out<WireLinePtr> lines{"lines"};

  FrameSourceProcess(sc_core::sc_module_name name, std::size_t view, FrameDesk& desk)
      : sc_module(name), view_(view), desk_(desk) {
    SC_HAS_PROCESS(FrameSourceProcess);
    SC_THREAD(run);
  }

  void begin(const GuardModel& guard, Expect expect) {
    guard_ = guard;
    expect_ = std::move(expect);
    stopped_ = finished_ = false;
    begin_.notify(sc_core::SC_ZERO_TIME);
  }
  /// Ends the sequence early.
  void stop() {
    stopped_ = true;
    wake_.notify(sc_core::SC_ZERO_TIME);
  }
  bool finished() const { return finished_; }
  const GuardModel& guard() const { return guard_; }

 private:
  void run() {
    for (;;) {
      wait(begin_);
      ahead_.clear();
      while (!stopped_) {
        const std::optional<SourceFrame> frame = desk_.request(view_);
        if (!frame) break;
        Batch next{make_wire_lines(*frame), 0};
        for (const WireLinePtr& line : next.lines) guard_.feed(*line, expected_);
        next.starts = guard_.starts();
        ahead_.push_back(std::move(next));
        announce();
        while (!ahead_.empty() && ahead_.front().starts <= guard_.settled_starts()) send_first();
      }
      guard_.finish(expected_);
      announce();
      while (!ahead_.empty()) send_first();
      send({nullptr});  // end of the sequence
      finished_ = true;
    }
  }
  /// The lines of one frame, to be sent when so many starts of frame are settled.
  struct Batch {
    std::vector<WireLinePtr> lines;
    std::size_t starts = 0;
  };

  void send_first() {
    send(ahead_.front().lines);
    ahead_.pop_front();
  }
  void announce() {
    for (ExpectedFrame& frame : expected_) expect_(std::move(frame));
    expected_.clear();
  }
  void send(const std::vector<WireLinePtr>& batch) {
    for (const WireLinePtr& line : batch) {
      while (!stopped_ && !lines->nb_write(line)) wait(lines->data_read_event() | wake_);
    }
  }

  std::size_t view_;
  FrameDesk& desk_;
  GuardModel guard_;
  std::vector<ExpectedFrame> expected_;
  std::deque<Batch> ahead_;
  Expect expect_;
  sc_core::sc_event begin_, wake_;
  bool stopped_ = false;
  bool finished_ = true;
};

}  // namespace trihedron::sim
