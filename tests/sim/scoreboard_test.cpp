// SPDX-License-Identifier: Apache-2.0
#include "sim/scoreboard.hpp"

#include <catch2/catch.hpp>

#include "sim/beats.hpp"
#include "sim/test_frames.hpp"

using namespace trihedron;
using namespace trihedron::sim;
using Catch::Matchers::Contains;

namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;
constexpr int kView = 1;

/// What a faultless device puts out for one frame, to be spoilt by the tests.
struct Output {
  GreyImage image = polygons(kWidth, kHeight, 12);
  std::vector<ContourLine> lines;
  std::vector<VertexRecord> records;

  Output() {
    const ViewFeatures golden = golden::run_front_end(image.pixels.data(), kWidth, kHeight, kWidth);
    for (int y = 0; y < kHeight; ++y) {
      ContourLine line;
      line.start = y == 0;
      for (int x = 0; x < kWidth; ++x) line.beats.push_back(pack(golden.at(x, y)));
      lines.push_back(line);
    }
    for (const Vertex& vertex : golden.vertices) {
      records.push_back({pack(vertex) | record_head(kVertexKind, kView, 0), false});
    }
    records.push_back({record_head(kEndKind, kView, 0) | golden.vertices.size() << 16, true});
  }
};

Scoreboard board_for(const GreyImage& image) {
  Scoreboard board({kView, true, {SettingsChange{}}}, [](FrameResult&&) {});
  const auto zero = [](std::size_t) { return std::uint64_t{0}; };
  board.look_up({zero, zero});
  board.expect({image, FrameEnd::kClean, 0});
  return board;
}

/// The verdict on an output: lines first, then records.
Scoreboard judged(const Output& output) {
  Scoreboard board = board_for(output.image);
  for (const ContourLine& line : output.lines) board.take(line);
  for (const VertexRecord& record : output.records) board.take(record);
  return board;
}

}  // namespace

TEST_CASE("a faultless output satisfies the scoreboard and is counted") {
  const Output output;
  REQUIRE(output.records.size() > 1);
  const Scoreboard board = judged(output);
  CHECK_FALSE(board.mismatch());
  CHECK(board.satisfied());
  Report report;
  board.add_to(report);
  CHECK(report.compared.frames == 1);
  CHECK(report.compared.beats == kWidth * kHeight);
  CHECK(report.compared.records == output.records.size());
}

TEST_CASE("a flipped bit anywhere in a contour beat is noticed where it is") {
  const std::pair<int, const char*> stage_of_bit[] = {
      {0, "second_contour"},     {1, "first_contour"},       {2, "contour beat"},
      {8, "gradient magnitude"}, {23, "gradient magnitude"}, {24, "gradient gx"},
      {39, "gradient gx"},       {40, "gradient gy"},        {55, "gradient gy"},
      {56, "contour beat"},      {63, "contour beat"}};
  for (const auto& [bit, stage] : stage_of_bit) {
    Output output;
    const int x = (7 * bit) % kWidth, y = (5 * bit) % kHeight;
    output.lines[static_cast<std::size_t>(y)].beats[static_cast<std::size_t>(x)] ^= std::uint64_t{1}
                                                                                    << bit;
    const Scoreboard board = judged(output);
    INFO("bit " << bit);
    REQUIRE(board.mismatch());
    CHECK(board.mismatch()->stage == stage);
    CHECK(board.mismatch()->x == x);
    CHECK(board.mismatch()->y == y);
    CHECK(board.mismatch()->view == kView);
    CHECK(board.mismatch()->expected != board.mismatch()->got);
    CHECK_FALSE(board.satisfied());
  }
}

TEST_CASE("a flipped bit anywhere in a vertex-stream record is noticed") {
  const std::size_t records = Output().records.size();
  for (const std::size_t record : {std::size_t{0}, records - 1}) {
    for (int bit = 0; bit < 64; ++bit) {
      Output output;
      output.records[record].data ^= std::uint64_t{1} << bit;
      INFO("record " << record << " bit " << bit);
      CHECK(judged(output).mismatch());
    }
    Output output;
    output.records[record].last = !output.records[record].last;
    CHECK(judged(output).mismatch());
  }
}

TEST_CASE("a missing, doubled or mis-marked line is noticed") {
  const auto spoilt = [](auto&& spoil) {
    Output output;
    spoil(output.lines);
    return judged(output);
  };
  using Lines = std::vector<ContourLine>;
  CHECK_FALSE(spoilt([](Lines& l) { l.pop_back(); }).satisfied());
  CHECK(spoilt([](Lines& l) { l.push_back(l.back()); }).mismatch());
  CHECK(spoilt([](Lines& l) { l[3].beats.pop_back(); }).mismatch());
  CHECK(spoilt([](Lines& l) { l[3].end = false; }).mismatch());
  CHECK(spoilt([](Lines& l) { l[0].start = false; }).mismatch());
  CHECK(spoilt([](Lines& l) { l[1].start = true; }).mismatch());
  CHECK(spoilt([](Lines& l) { l[5].stray_start = 2; }).mismatch());
}

TEST_CASE("a vertex too few or too many is noticed") {
  Output fewer;
  fewer.records.erase(fewer.records.begin());
  CHECK(judged(fewer).mismatch());
  Output more;
  more.records.insert(more.records.end() - 1, more.records.front());
  CHECK(judged(more).mismatch());
}

TEST_CASE("a device that falls silent is described by what is missing") {
  Output output;
  output.lines.resize(12);
  output.records.clear();
  const Mismatch missing = judged(output).missing();
  CHECK(missing.y == 12);
  CHECK_THAT(missing.text(), Contains("30 lines") && Contains("got 12 lines, no end-of-frame"));
}
