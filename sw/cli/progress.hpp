// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace trihedron::cli {

/// A line on standard error that says how far the work is, its rate and the time left. Only where
/// standard error is a terminal; gone when the object goes.
class Progress {
 public:
  /// `count` things are to be done, if known; `what` names them ("scenes").
  Progress(std::optional<std::size_t> count, std::string what, bool quiet = false);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done.
  void step();
  /// Takes the line away for a moment: before something else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<std::size_t> count_;
  std::size_t done_ = 0;
  std::string what_;
  bool shown_;
  Clock::time_point start_, last_;
};

/// "12/63 scenes, 2.1/s, 24 s left": without a count "12 scenes, 2.1/s".
std::string progress_line(std::size_t done, std::optional<std::size_t> count,
                          const std::string& what, double seconds);

}  // namespace trihedron::cli
