// SPDX-License-Identifier: Apache-2.0
#include "sim/scoreboard.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "sim/beats.hpp"

namespace trihedron::sim {
namespace {

template <typename Number>
std::string decimal(Number value) {
  return std::to_string(value);
}

std::string hex(std::uint64_t value) {
  char text[24];
  std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(value));
  return text;
}

std::string describe(const Vertex& v) {
  return "(" + decimal(v.x) + ", " + decimal(v.y) + ") branches " + decimal(v.branches) +
         " pattern " + decimal(v.pattern) + " strength " + decimal(v.strength);
}

// A frame lower than the smallest legal one has no whole window: gradient 0, no contour.
ViewFeatures golden_features(const GreyImage& image, const golden::FrontEndConfig& thresholds) {
  if (image.height >= kMinSizePx) {
    return golden::run_front_end(image.pixels.data(), image.width, image.height, image.width,
                                 thresholds);
  }
  ViewFeatures none;
  none.width = image.width;
  none.height = image.height;
  none.contour.resize(image.pixels.size());
  return none;
}

// The vertices beyond the limit are counted, not sent.
void apply_limit(ViewFeatures& features, int limit) {
  const auto sent = std::min(features.vertices.size(), static_cast<std::size_t>(limit));
  features.vertices_lost += static_cast<std::uint32_t>(features.vertices.size() - sent);
  features.vertices.resize(sent);
}

}  // namespace

void Scoreboard::expect(ExpectedFrame&& expected) {
  OpenFrame frame;
  const GreyImage& image = expected.image;
  if (setup_.check) {
    const SettingsChange& in_force =
        setup_.settings.at(std::min(expected.changes, setup_.settings.size() - 1));
    frame.golden = golden_features(image, in_force.thresholds);
    apply_limit(frame.golden, in_force.vertex_limit);
  }
  frame.got.width = image.width;
  frame.got.height = image.height;
  frame.got.contour.resize(image.pixels.size());
  frame.expected = std::move(expected);
  frames_.push_back(std::move(frame));
}

void Scoreboard::take(const ContourLine& line) {
  if (mismatch_) return;
  const auto open = std::find_if(frames_.begin(), frames_.end(),
                                 [](const OpenFrame& f) { return !f.contour_complete(); });
  if (open == frames_.end()) {
    return differ(frames_.size(), "contour stream", -1, -1, "no further line", "a line");
  }
  OpenFrame& frame = *open;
  const auto position = static_cast<std::size_t>(open - frames_.begin());
  const int y = frame.lines;
  const int width = frame.expected.image.width;
  if (static_cast<int>(line.beats.size()) != width || !line.end) {
    return differ(position, "contour tlast", width - 1, y, decimal(width) + " beats in the line",
                  decimal(line.beats.size()));
  }
  if (line.start != (y == 0) || line.stray_start >= 0) {
    return differ(position, "contour tuser", std::max(0, line.stray_start), y,
                  y == 0 ? "a start of frame" : "no start of frame", "the opposite");
  }
  if (y == 0) {
    frame.start_clock = pins_.start_clock(frame.expected.start_index);
    frame.latency_clocks = line.first_clock - frame.start_clock;
  }
  frame.last_clock = line.last_clock;
  frame.contour_stalls += line.stalls;
  ContourBeat* row = frame.got.contour.data() + static_cast<std::ptrdiff_t>(y) * width;
  std::transform(line.beats.begin(), line.beats.end(), row, unpack_beat);
  if (setup_.check) compare_line(position, line);
  ++frame.lines;
  retire();
}

void Scoreboard::compare_line(std::size_t position, const ContourLine& line) {
  const OpenFrame& frame = frames_[position];
  const int y = frame.lines;
  const ContourBeat* golden =
      frame.golden.contour.data() + static_cast<std::ptrdiff_t>(y) * frame.expected.image.width;
  for (std::size_t i = 0; i < line.beats.size(); ++i) {
    if (pack(golden[i]) == line.beats[i]) continue;
    const ContourBeat got = unpack_beat(line.beats[i]);
    const ContourBeat& want = golden[i];
    const int x = static_cast<int>(i);
    const auto one = [&](const char* stage, int expected, int seen) {
      differ(position, stage, x, y, decimal(expected), decimal(seen));
    };
    if (want.gx != got.gx) return one("gradient gx", want.gx, got.gx);
    if (want.gy != got.gy) return one("gradient gy", want.gy, got.gy);
    if (want.magnitude != got.magnitude) {
      return one("gradient magnitude", want.magnitude, got.magnitude);
    }
    if ((want.flags ^ got.flags) & kFirstContour) {
      return one("first_contour", (want.flags & kFirstContour) != 0,
                 (got.flags & kFirstContour) != 0);
    }
    if ((want.flags ^ got.flags) & kContour) {
      return one("second_contour", want.contour(), got.contour());
    }
    return differ(position, "contour beat", x, y, hex(pack(want)), hex(line.beats[i]));
  }
  compared_.beats += line.beats.size();
}

void Scoreboard::take(const VertexRecord& record) {
  if (mismatch_) return;
  const auto open =
      std::find_if(frames_.begin(), frames_.end(), [](const OpenFrame& f) { return !f.ended; });
  const auto position = static_cast<std::size_t>(open - frames_.begin());
  if (open == frames_.end()) {
    return differ(position, "vertex stream", -1, -1, "no further record", hex(record.data));
  }
  const unsigned kind = record_kind(record.data);
  const std::int64_t tag = retired_ + static_cast<std::int64_t>(position);
  const std::uint64_t head = record_head(kind, setup_.view, tag);
  if (kind > kEndKind || (record.data & kHeadMask) != head || record.last != (kind == kEndKind)) {
    return differ(position, "vertex record head", -1, -1,
                  hex(head) + (kind == kEndKind ? " with tlast" : ""),
                  hex(record.data & kHeadMask) + (record.last ? " with tlast" : ""));
  }
  if (kind == kEndKind) {
    take_end(position, record.data);
  } else {
    open->got.vertices.push_back(unpack_vertex(record.data));
    if (setup_.check) compare_vertex(position);
  }
}

void Scoreboard::compare_vertex(std::size_t position) {
  const OpenFrame& frame = frames_[position];
  const std::size_t index = frame.got.vertices.size() - 1;
  const Vertex& got = frame.got.vertices.back();
  if (index >= frame.golden.vertices.size()) {
    return differ(position, "vertices", got.x, got.y, "no further vertex", describe(got));
  }
  const Vertex& want = frame.golden.vertices[index];
  if (pack(want) != pack(got)) {
    return differ(position, "vertices", want.x, want.y, describe(want), describe(got));
  }
  ++compared_.records;
}

void Scoreboard::take_end(std::size_t position, std::uint64_t record) {
  OpenFrame& frame = frames_[position];
  const EndOfFrame end = unpack_end(record);
  const auto number = [&](const char* stage, std::uint64_t expected, std::uint64_t got) {
    if (expected != got && !mismatch_) {
      differ(position, stage, -1, -1, decimal(expected), decimal(got));
    }
  };
  number("end of frame: vertices sent", frame.got.vertices.size(), end.sent);
  number("end of frame: status",
         static_cast<std::uint16_t>(frame.expected.end) | (end.lost ? kVerticesLost : 0),
         end.status);
  if (setup_.check) {
    number("end of frame: vertices expected", frame.golden.vertices.size(), end.sent);
    number("end of frame: vertices lost", frame.golden.vertices_lost, end.lost);
  }
  if (mismatch_) return;
  compared_.records += setup_.check;
  frame.got.vertices_lost = end.lost;
  frame.status = end.status;
  frame.ended = true;
  retire();
}

void Scoreboard::retire() {
  while (!mismatch_ && !frames_.empty() && frames_.front().ended &&
         frames_.front().contour_complete()) {
    OpenFrame& frame = frames_.front();
    ++statistics_.frames;
    statistics_.vertices += frame.got.vertices.size();
    statistics_.vertices_lost += frame.got.vertices_lost;
    statistics_.last_vertices = static_cast<std::uint32_t>(frame.got.vertices.size());
    statistics_.last_vertices_lost = frame.got.vertices_lost;
    statistics_.latency_clocks = std::max(statistics_.latency_clocks, frame.latency_clocks);
    compared_.frames += setup_.check;
    sink_({setup_.view, retired_, std::move(frame.got), frame.status, frame.latency_clocks,
           frame.last_clock - frame.start_clock + 1, pins_.input_stalls(frame.expected.start_index),
           frame.contour_stalls});
    ++retired_;
    frames_.pop_front();
  }
}

void Scoreboard::add_to(Report& report) const {
  report.compared.frames += compared_.frames;
  report.compared.beats += compared_.beats;
  report.compared.records += compared_.records;
  ViewStatistics& view = report.views[static_cast<std::size_t>(setup_.view)];
  view.frames = statistics_.frames;
  view.vertices = statistics_.vertices;
  view.vertices_lost = statistics_.vertices_lost;
  view.latency_clocks = statistics_.latency_clocks;
  view.last_vertices = statistics_.last_vertices;
  view.last_vertices_lost = statistics_.last_vertices_lost;
}

Mismatch Scoreboard::missing() const {
  Mismatch hang;
  hang.view = setup_.view;
  hang.frame = retired_;
  hang.stage = "output";
  hang.expected = "the next frame";
  hang.got = "no transfer on any stream";
  if (frames_.empty()) return hang;
  const OpenFrame& frame = frames_.front();
  hang.y = frame.lines;
  hang.expected = decimal(frame.expected.image.height) + " lines and an end-of-frame record";
  hang.got = decimal(frame.lines) + " lines, " + (frame.ended ? "the" : "no") +
             " end-of-frame record, then silence";
  return hang;
}

void Scoreboard::differ(std::size_t position, const char* stage, int x, int y, std::string expected,
                        std::string got) {
  mismatch_ = Mismatch{};
  mismatch_->view = setup_.view;
  mismatch_->frame = retired_ + static_cast<std::int64_t>(position);
  mismatch_->stage = stage;
  mismatch_->x = x;
  mismatch_->y = y;
  mismatch_->expected = std::move(expected);
  mismatch_->got = std::move(got);
}

}  // namespace trihedron::sim
