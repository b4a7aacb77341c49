// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace trihedron::cli {
namespace {

std::string duration(double seconds) {
  const auto s = static_cast<long>(std::ceil(seconds));
  if (s < 100) return fmt::format("{} s", s);
  if (s < 6000) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace

std::string progress_line(std::size_t done, std::optional<std::size_t> count,
                          const std::string& what, double seconds) {
  std::string line =
      count ? fmt::format("{}/{} {}", done, *count, what) : fmt::format("{} {}", done, what);
  if (done == 0 || seconds <= 0) return line;
  const double rate = static_cast<double>(done) / seconds;
  line += fmt::format(", {:.3g}/s", rate);
  if (count && *count > done)
    line += ", " + duration(static_cast<double>(*count - done) / rate) + " left";
  return line;
}

Progress::Progress(std::optional<std::size_t> count, std::string what, bool quiet)
    : count_(count),
      what_(std::move(what)),
      shown_(!quiet && isatty(STDERR_FILENO) != 0),
      start_(Clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::step() {
  ++done_;
  constexpr std::chrono::milliseconds kPause(100);  // a person reads no faster
  const Clock::time_point now = Clock::now();
  if (!shown_ || (now - last_ < kPause && count_ != done_)) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r{}\033[K", progress_line(done_, count_, what_, seconds));
}

void Progress::clear() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

}  // namespace trihedron::cli
