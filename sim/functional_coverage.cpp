// SPDX-License-Identifier: Apache-2.0
#include "sim/functional_coverage.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "golden/error.hpp"
#include "sim/guard_model.hpp"
#include "sim/random_stimulus.hpp"

namespace trihedron::sim {
namespace {

using Names = std::vector<std::string>;

const Names kContents = {"flat", "noise", "faint noise", "saturated", "step",    "polygons",
                         "dots", "ramp",  "stripes",     "picture",   "extremes"};
const Names kLegalSizes = {"5x5",  "5 wide", "5 high", "up to 16",   "odd",
                           "even", "wide",   "tall",   "full width", "full height"};
const Names kIllegalSizes = {"too narrow", "too wide", "too low", "too tall"};
const Names kFaultNames = {"none", "short line", "long line", "no start", "early start", "cut off"};
const Names kStalls = {"none", "10 %", "50 %", "bursts", "stops"};
const Names kHeights = {"not known", "right", "too low", "too high"};
const Names kEvents = {"short line", "long line",   "too wide",     "too narrow",   "too tall",
                       "no start",   "early start", "too few rows", "vertices lost"};
const Names kEnds = {"clean", "bad line", "bad height", "too few rows", "vertices lost"};
const Names kViewNames = {"view 0", "view 1", "view 2"};
const Names kSlopes = {"-large", "-small", "0", "+small", "+large"};
const Names kLevels = {"lowest", "lower half", "reset", "upper half", "highest"};

Names numbers(int first, int last) {
  Names names;
  for (int i = first; i <= last; ++i) names.push_back(std::to_string(i));
  return names;
}

Names both(Names a, const Names& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string pair(const std::string& a, const std::string& b) { return a + " | " + b; }

Names cross(const Names& a, const Names& b) {
  Names names;
  for (const std::string& left : a) {
    for (const std::string& right : b) names.push_back(pair(left, right));
  }
  return names;
}

std::string size_class(const GreyImage& image) {
  const int width = image.width, height = image.height;
  if (width < kMinSizePx) return "too narrow";
  if (width > kMaxWidthPx) return "too wide";
  if (height < kMinSizePx) return "too low";
  if (height > kMaxHeightPx) return "too tall";
  if (width == kMaxWidthPx) return "full width";
  if (height == kMaxHeightPx) return "full height";
  if (width == kMinSizePx && height == kMinSizePx) return "5x5";
  if (width > 160) return "wide";
  if (height > 160) return "tall";
  if (width == kMinSizePx) return "5 wide";
  if (height == kMinSizePx) return "5 high";
  if (width <= 16 && height <= 16) return "up to 16";
  return width % 2 ? "odd" : "even";
}

std::string stall_class(const StallProfile& stalls) {
  if (stalls.probability == 0.0) return kStalls[0];
  if (stalls.longest == kLongestStallClocks) return kStalls[4];
  if (stalls.longest > 1) return kStalls[3];
  return stalls.probability < 0.3 ? kStalls[1] : kStalls[2];
}

std::string level(int value, int lowest, int reset, int highest) {
  if (value == lowest) return kLevels[0];
  if (value == highest) return kLevels[4];
  if (value == reset) return kLevels[2];
  return value < (lowest + highest) / 2 ? kLevels[1] : kLevels[3];
}

std::string height_class(int known, int height) {
  if (known == 0) return kHeights[0];
  return known == height ? kHeights[1] : kHeights[known < height ? 2 : 3];
}

std::string size_change(const GreyImage& before, const GreyImage& now) {
  if (now.width != before.width) return now.width > before.width ? "wider" : "narrower";
  if (now.height != before.height) return now.height > before.height ? "higher" : "lower";
  return "same";
}

}  // namespace

FunctionalCoverage::FunctionalCoverage() {
  const std::array<std::pair<const char*, Names>, 25> declared = {{
      {"frames per view", both(numbers(1, 5), {"more than 256"})},
      {"size x content", cross(kLegalSizes, kContents)},
      {"size x contour stalls", cross(kLegalSizes, kStalls)},
      {"size change x view", cross({"same", "wider", "narrower", "higher", "lower"}, kViewNames)},
      {"content x thresholds", cross(kContents, {"reset", "random"})},
      {"pixel idles x contour stalls", cross(kStalls, kStalls)},
      {"contour stalls x vertex stalls", cross(kStalls, kStalls)},
      {"register stalls x access",
       cross(kStalls, {"settings only", "every register", "polling", "both"})},
      {"fault x FRAME_HEIGHT", cross(both(kFaultNames, kIllegalSizes), kHeights)},
      {"fault x contour stalls", cross(both(kFaultNames, kIllegalSizes), kStalls)},
      {"event x view", cross(kEvents, kViewNames)},
      {"frame end x view", cross(kEnds, kViewNames)},
      {"threshold",
       cross({"NOISE_FLOOR", "MEAN_LIMIT", "SUPPORT", "BRANCH_FLOOR", "MIN_TURN"}, kLevels)},
      {"VERTEX_LIMIT", {"0", "1 .. 20", "21 .. 65534", "none"}},
      {"FLUSH_TIMEOUT x gap", cross({"16 .. 64", "up to 4000", "above"}, {"none", "short"})},
      {"gap that ends a frame", {"16 .. 64", "up to 4000", "above"}},
      {"reset in mid-frame", {"no", "yes"}},
      {"change in mid-frame",
       {"thresholds", "held", "released", "view off", "view on", "height known", "height unknown"}},
      {"contour flags", {"none", "second only", "first only", "both"}},
      {"magnitude", {"0", "below noise floor", "lower half", "upper half", "saturated"}},
      {"gx x gy", cross(kSlopes, kSlopes)},
      {"vertex branches", numbers(0, 8)},
      {"vertex strength", {"25 .. 35", "36 .. 49", "50 .. 64"}},
      {"vertex pattern: first branch", numbers(0, 15)},
      {"vertex pattern: last branch", numbers(0, 15)},
  }};
  for (const auto& [group, bins] : declared) {
    for (const std::string& bin : bins) groups_[group][bin] = 0;
  }
  // FRAME_HEIGHT has no value below 5 and none above the largest height.
  for (const char* impossible :
       {"too low | right", "too low | too low", "too tall | right", "too tall | too high"}) {
    groups_["fault x FRAME_HEIGHT"].erase(impossible);
  }
}

void FunctionalCoverage::add(const std::string& group, const std::string& bin,
                             std::uint64_t times) {
  const auto bins = groups_.find(group);
  if (bins == groups_.end() || bins->second.count(bin) == 0) {
    throw Error("functional coverage: no bin '" + bin + "' in group '" + group + "'");
  }
  bins->second[bin] += times;
}

void FunctionalCoverage::sample(const RegressionCase& stimulus, const Report& report) {
  const RunOptions& options = stimulus.options;
  const std::size_t frames = stimulus.frames[0].size();
  add("frames per view", frames > 256 ? "more than 256" : std::to_string(frames));
  sample_settings(options);
  sample_changes(options);
  for (std::size_t view = 0; view < kViews; ++view) {
    sample_frames(stimulus, view);
    const ViewStatistics& count = report.views[view];
    for (std::size_t event = 0; event < kGuardEvents; ++event) {
      if ((count.stream_error_kinds >> event) & 1) {
        add("event x view", pair(kEvents[event], kViewNames[view]));
      }
    }
    if (count.vertices_lost > 0) add("event x view", pair(kEvents.back(), kViewNames[view]));
  }
}

void FunctionalCoverage::sample_frames(const RegressionCase& stimulus, std::size_t view) {
  const RunOptions& options = stimulus.options;
  const std::string stalls = stall_class(options.contour_stalls);
  const bool random =
      options.thresholds.first_contour.noise_floor != golden::FirstContourConfig{}.noise_floor;
  const std::string timeout = options.flush_timeout <= 64     ? "16 .. 64"
                              : options.flush_timeout <= 4000 ? "up to 4000"
                                                              : "above";
  const std::vector<SourceFrame>& frames = stimulus.frames[view];
  int height = options.frame_height;
  std::size_t changes = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const SourceFrame& frame = frames[i];
    const std::string size = size_class(frame.image);
    const std::string& content = kContents[static_cast<std::size_t>(stimulus.contents[view][i])];
    const bool legal = std::find(kLegalSizes.begin(), kLegalSizes.end(), size) != kLegalSizes.end();
    if (legal) {
      add("size x content", pair(size, content));
      add("size x contour stalls", pair(size, stalls));
      add("content x thresholds", pair(content, random ? "random" : "reset"));
      if (i > 0)
        add("size change x view",
            pair(size_change(frames[i - 1].image, frame.image), kViewNames[view]));
    }
    const std::string fault = legal ? kFaultNames[static_cast<std::size_t>(frame.fault)] : size;
    add("fault x FRAME_HEIGHT", pair(fault, height_class(height, frame.image.height)));
    add("fault x contour stalls", pair(fault, stalls));
    if (frame.gap_clocks > options.flush_timeout) {
      add("gap that ends a frame", timeout);
    } else {
      add("FLUSH_TIMEOUT x gap", pair(timeout, frame.gap_clocks > 0 ? "short" : "none"));
    }
    if (!frame.holds) continue;
    const SettingsChange& change = options.changes[changes++];
    if (!change.held) height = change.frame_height;
  }
}

void FunctionalCoverage::sample_settings(const RunOptions& options) {
  const std::string contour = stall_class(options.contour_stalls);
  add("pixel idles x contour stalls", pair(stall_class(options.pixel_idles), contour));
  add("contour stalls x vertex stalls", pair(contour, stall_class(options.vertex_stalls)));
  const char* access = options.exercise_registers
                           ? (options.poll_registers ? "both" : "every register")
                       : options.poll_registers ? "polling"
                                                : "settings only";
  add("register stalls x access", pair(stall_class(options.register_stalls), access));
  add("reset in mid-frame", options.prelude_clocks > 0 ? "yes" : "no");
  const golden::FrontEndConfig& now = options.thresholds;
  const golden::FrontEndConfig reset;
  const auto threshold = [this](const char* name, int value, int low, int at_reset, int high) {
    add("threshold", pair(name, level(value, low, at_reset, high)));
  };
  threshold("NOISE_FLOOR", now.first_contour.noise_floor, 1, reset.first_contour.noise_floor, 511);
  threshold("MEAN_LIMIT", now.first_contour.mean_limit, 1, reset.first_contour.mean_limit, 31);
  threshold("SUPPORT", now.second_contour.support, 0, reset.second_contour.support, 12775);
  threshold("BRANCH_FLOOR", now.vertices.branch_floor, 1, reset.vertices.branch_floor, 511);
  threshold("MIN_TURN", now.vertices.min_turn, 1, reset.vertices.min_turn, 16);
  const int limit = options.vertex_limit;
  add("VERTEX_LIMIT", limit == 0                 ? "0"
                      : limit <= 20              ? "1 .. 20"
                      : limit == kMaxVertexLimit ? "none"
                                                 : "21 .. 65534");
}

void FunctionalCoverage::sample_changes(const RunOptions& options) {
  SettingsChange before;
  before.frame_height = options.frame_height;
  for (const SettingsChange& change : options.changes) {
    const auto note = [this](bool happened, const char* bin) {
      if (happened) add("change in mid-frame", bin);
    };
    note(!change.held && !before.held, "thresholds");
    note(change.held, "held");
    note(!change.held && before.held, "released");
    note((before.enabled & ~change.enabled) != 0, "view off");
    note((change.enabled & ~before.enabled) != 0, "view on");
    note(before.frame_height == 0 && change.frame_height != 0, "height known");
    note(before.frame_height != 0 && change.frame_height == 0, "height unknown");
    if (change.held) {
      before.held = true;
      before.enabled = change.enabled;
    } else {
      before = change;
    }
  }
}

}  // namespace trihedron::sim
