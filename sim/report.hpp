// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/stimulus.hpp"

namespace trihedron::sim {

/// What one view's streams did in one run. Clocks are counted from the end of reset.
struct ViewStatistics {
  std::uint64_t frames = 0;          ///< that came out, cut ones included
  std::uint64_t pixels = 0;          ///< accepted at the input
  std::uint64_t input_stalls = 0;    ///< clocks with a pixel offered but not accepted
  std::uint64_t input_idles = 0;     ///< clocks without a pixel offered, first to last pixel
  std::uint64_t contour_beats = 0;   ///< handed over at the contour stream
  std::uint64_t contour_stalls = 0;  ///< clocks with a beat offered but not taken
  std::uint64_t latency_clocks = 0;  ///< first pixel in to its contour beat out, worst frame
  std::uint64_t vertices = 0;
  std::uint64_t vertices_lost = 0;       ///< did not fit into a frame's list
  std::uint32_t last_vertices = 0;       ///< of the last frame
  std::uint32_t last_vertices_lost = 0;  ///< of the last frame
  std::uint32_t stream_errors = 0;       ///< faults that the input stream held
  std::uint32_t stream_error_kinds = 0;  ///< one bit per kind, as in the STATUS register
};

/// How much was held against the golden model and found equal.
struct Compared {
  std::uint64_t frames = 0;
  std::uint64_t beats = 0;    ///< contour beats
  std::uint64_t records = 0;  ///< vertex and end-of-frame records
  std::uint64_t registers = 0;
};

/// The first difference between hardware and golden model, or a broken protocol rule.
struct Mismatch {
  std::uint64_t seed = 0;
  int view = 0;
  std::int64_t frame = 0;  ///< frames of this view that came out before, in this run
  std::string stage;       ///< gradient, first_contour, second_contour, vertices, registers, ...
  int x = -1;              ///< column, px; -1: not about a pixel
  int y = -1;              ///< row, px
  std::string expected;
  std::string got;
  std::uint64_t clock = 0;  ///< since reset

  /// One line for a person.
  std::string text() const;
};

/// Outcome of one run.
struct Report {
  std::uint64_t seed = 0;
  std::uint64_t clocks = 0;
  std::array<ViewStatistics, kViews> views;
  Compared compared;
  std::optional<Mismatch> mismatch;

  /// Nothing differed and, when the run was checked, something was compared.
  bool passed() const { return !mismatch && compared.frames > 0 && compared.beats > 0; }
};

}  // namespace trihedron::sim
