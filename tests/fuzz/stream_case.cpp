// SPDX-License-Identifier: Apache-2.0
#include "fuzz/stream_case.hpp"

#include <algorithm>

#include "sim/pattern.hpp"

namespace trihedron::fuzz {
namespace {

// Bounds the time of a case: about a tenth of a second with sanitizers.
constexpr int kMostPixels = 12000;
constexpr std::size_t kMostPhases = 3;
constexpr sim::StallProfile kStalls[] = {{}, {}, {0.1, 1}, {0.5, 1}, {0.02, 64}};

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  bool empty() const { return at_ == end_; }
  /// The next byte, 0 after the end.
  int next() { return empty() ? 0 : *at_++; }
  /// `low` + the next two bytes, within the range.
  int between(int low, int high) {
    const int high_byte = next();
    return low + (high_byte * 256 + next()) % (high - low + 1);
  }

 private:
  const std::uint8_t *at_, *end_;
};

sim::StallProfile stalls(Bytes& in) { return kStalls[in.next() % 5]; }

class Decoder {
 public:
  Decoder(const std::uint8_t* data, std::size_t size) : in_(data, size) {}

  StreamCase decode() {
    draw_options();
    while (out_.phases.empty() || (!in_.empty() && out_.phases.size() < kMostPhases)) draw_phase();
    return std::move(out_);
  }

 private:
  void draw_options() {
    sim::RunOptions& options = out_.options;
    options.seed = static_cast<std::uint64_t>(in_.next());
    options.pixel_idles = stalls(in_);
    options.contour_stalls = stalls(in_);
    options.vertex_stalls = stalls(in_);
    options.register_stalls = stalls(in_);
    // Far above the pauses that a driver makes by itself (docs/verification.md).
    options.flush_timeout = options.pixel_idles.probability == 0
                                ? 16 + in_.next() % 48
                                : 512 + in_.next() + options.pixel_idles.longest;
  }

  void draw_phase() {
    Phase& phase = out_.phases.emplace_back();
    draw_settings(phase.settings);
    const int height = phase.settings.frame_height;
    for (int runs = 1 + in_.next() % 32; runs > 0 && !in_.empty(); --runs) draw_run(phase);
    for (auto& lines : phase.lines) append_closing_frame(lines, std::max(height, sim::kMinSizePx));
  }

  // Reset values, unless the first byte has them follow.
  void draw_settings(sim::SettingsChange& settings) {
    const int flags = in_.next();
    if (flags & 1) {
      settings.thresholds.first_contour.noise_floor = in_.between(1, 511);
      settings.thresholds.first_contour.mean_limit = in_.between(1, 31);
      settings.thresholds.second_contour.support = in_.between(0, 12775);
      settings.thresholds.vertices.branch_floor = in_.between(1, 511);
      settings.thresholds.vertices.min_turn = in_.between(1, 16);
    }
    if (flags & 2) settings.vertex_limit = in_.next() % 32;
    if (flags & 4) settings.frame_height = sim::kMinSizePx + in_.next() % 16;
    if (flags & 8) settings.enabled = static_cast<unsigned>(in_.next()) % 8;
  }

  // Equal lines of one view: a frame, a part of one, or something that is none.
  void draw_run(Phase& phase) {
    const int head = in_.next();
    auto& lines = phase.lines[static_cast<std::size_t>(head % sim::kViews)];
    const int width = draw_width();
    const int code = in_.next();
    const int rows = code == 255 ? sim::kMaxHeightPx + 1 : 1 + code % 20;
    if (width * rows > pixels_left_) return;
    pixels_left_ -= width * rows;
    widest_ = std::max(widest_, width);
    const sim::GreyImage image = draw_image(width, rows);
    const int which = in_.next() % rows;  // the row that is special
    for (int y = 0; y < rows; ++y) {
      sim::WireLine line;
      const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * width;
      line.pixels.assign(first, first + width);
      line.start = y == 0 && (head & 4) == 0;
      if (y == which && (head & 8)) line.end = false;
      if (y == which && (head & 16)) line.stray_start = in_.next() % width;
      if (y == which) line.gap_clocks = draw_gap(head >> 5);
      lines.push_back(line);
    }
  }

  int draw_width() {
    const int code = in_.next();
    return code < 250 ? 1 + code % 40 : sim::kMaxWidthPx + code - 252;
  }

  sim::GreyImage draw_image(int width, int rows) {
    const int code = in_.next();
    sim::Random random(static_cast<std::uint64_t>(code));
    if (code % 16 < sim::kPatterns) {
      return sim::make_image(static_cast<sim::Pattern>(code % 16), width, rows, random, {});
    }
    // The bytes themselves, shifted from row to row.
    sim::GreyImage image{width, rows, {}};
    std::vector<std::uint8_t> raw(static_cast<std::size_t>(std::min(width, 40)));
    for (std::uint8_t& grey : raw) grey = static_cast<std::uint8_t>(in_.next());
    for (int i = 0; i < width * rows; ++i) {
      image.pixels.push_back(raw[static_cast<std::size_t>(i + i / width) % raw.size()]);
    }
    return image;
  }

  // None, far shorter or far longer than FLUSH_TIMEOUT.
  int draw_gap(int code) {
    const sim::RunOptions& options = out_.options;
    if (code < 5) return 0;
    if (code < 7) return 1 + in_.next() % std::min(100, options.flush_timeout / 4);
    return 3 * options.flush_timeout + 40 * widest_ +
           6 * std::max(options.contour_stalls.longest, options.vertex_stalls.longest);
  }

  void append_closing_frame(std::vector<sim::WireLine>& lines, int height) {
    constexpr int kWidth = 8;
    sim::Random random(1);
    const sim::GreyImage image =
        sim::make_image(sim::Pattern::kPolygons, kWidth, height, random, {});
    for (int y = 0; y < height; ++y) {
      sim::WireLine line;
      line.pixels.assign(image.pixels.begin() + y * kWidth,
                         image.pixels.begin() + (y + 1) * kWidth);
      line.start = y == 0;
      lines.push_back(line);
    }
  }

  Bytes in_;
  StreamCase out_;
  int pixels_left_ = kMostPixels;
  int widest_ = sim::kMinSizePx;
};

}  // namespace

StreamCase decode_case(const std::uint8_t* data, std::size_t size) {
  return Decoder(data, size).decode();
}

}  // namespace trihedron::fuzz
