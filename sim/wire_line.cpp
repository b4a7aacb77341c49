// SPDX-License-Identifier: Apache-2.0
#include "sim/wire_line.hpp"

#include <algorithm>

namespace trihedron::sim {
namespace {

// A frame's settings are those at its first pixel: what is written later in the same line must
// not reach it.
constexpr int kHoldRow = 0;

void spoil(WireLine& line, const SourceFrame& frame) {
  const int width = static_cast<int>(line.pixels.size());
  switch (frame.fault) {
    case Fault::kShortLine:
      line.pixels.resize(static_cast<std::size_t>(std::max(1, width - frame.fault_px)));
      break;
    case Fault::kLongLine:
      line.pixels.resize(static_cast<std::size_t>(width + frame.fault_px), line.pixels.back());
      break;
    case Fault::kEarlyStart:
      line.stray_start = std::min(frame.fault_px, width - 1);
      break;
    case Fault::kNone:
    case Fault::kMissingStart:
    case Fault::kCutFrame:
      break;
  }
}

}  // namespace

std::vector<WireLinePtr> make_wire_lines(const SourceFrame& frame) {
  const GreyImage& image = frame.image;
  const int rows =
      frame.fault == Fault::kCutFrame ? std::min(image.height, frame.fault_line + 1) : image.height;
  std::vector<WireLinePtr> lines;
  lines.reserve(static_cast<std::size_t>(rows));
  for (int y = 0; y < rows; ++y) {
    auto line = std::make_shared<WireLine>();
    const std::uint8_t* row = image.pixels.data() + static_cast<std::ptrdiff_t>(y) * image.width;
    line->pixels.assign(row, row + image.width);
    line->start = y == 0 && frame.fault != Fault::kMissingStart;
    line->gap_clocks = y == 0 ? frame.gap_clocks : 0;
    line->hold = y == kHoldRow && frame.holds;
    if (y == frame.fault_line) spoil(*line, frame);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace trihedron::sim
