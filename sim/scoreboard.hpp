// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "golden/features.hpp"
#include "golden/front_end.hpp"
#include "sim/guard_model.hpp"
#include "sim/report.hpp"
#include "sim/simulator.hpp"
#include "sim/stream_monitor.hpp"

namespace trihedron::sim {

/// Scoreboard of one view: puts the frames back together from lines and records, and holds every
/// beat and record against the golden model as soon as it arrives. Knows nothing of SystemC.
class Scoreboard {
 public:
  struct Setup {
    int view = 0;
    bool check = false;                    ///< false: only the streams' shape is checked
    std::vector<SettingsChange> settings;  ///< in force at first, after the first change, ...
  };

  Scoreboard(const Setup& setup, FrameSink sink) : setup_(setup), sink_(std::move(sink)) {}

  void expect(ExpectedFrame&& frame);
  void take(const ContourLine& line);
  void take(const VertexRecord& record);

  /// No expected frame is missing any beat or record.
  bool satisfied() const { return frames_.empty(); }
  /// The first difference; its clock and seed are the caller's to fill in.
  const std::optional<Mismatch>& mismatch() const { return mismatch_; }
  /// Names what has not arrived, for a device that hangs.
  Mismatch missing() const;

  /// Adds what was compared and this view's frames and vertices.
  void add_to(Report& report) const;
  /// What only the pins know of a frame, by the number of its start of frame.
  struct Pins {
    std::function<std::uint64_t(std::size_t start_index)> start_clock;   ///< first pixel accepted
    std::function<std::uint64_t(std::size_t start_index)> input_stalls;  ///< so far; asked last
  };
  void look_up(Pins pins) { pins_ = std::move(pins); }

 private:
  struct OpenFrame {
    ExpectedFrame expected;
    ViewFeatures golden;  ///< empty unless checked
    ViewFeatures got;
    std::uint16_t status = 0;
    std::uint64_t start_clock = 0, latency_clocks = 0, last_clock = 0, contour_stalls = 0;
    int lines = 0;
    bool ended = false;  ///< its end-of-frame record has arrived
    bool contour_complete() const { return lines == expected.image.height; }
  };

  void compare_line(std::size_t position, const ContourLine& line);
  void compare_vertex(std::size_t position);
  void take_end(std::size_t position, std::uint64_t record);
  void retire();
  void differ(std::size_t position, const char* stage, int x, int y, std::string expected,
              std::string got);

  Setup setup_;
  FrameSink sink_;
  Pins pins_;
  std::deque<OpenFrame> frames_;  ///< expected, oldest first
  std::int64_t retired_ = 0;
  std::optional<Mismatch> mismatch_;
  Compared compared_;
  ViewStatistics statistics_;
};

}  // namespace trihedron::sim
