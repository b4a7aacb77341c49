// SPDX-License-Identifier: Apache-2.0
// One instance of trihedron_top, of any parameters, against the golden model: random frames, idles
// and stalls on all views, every beat and record, and the registers that depend on the parameters.
// usage: bench VIEWS WIDTH HEIGHT FRACTION_BITS RUNS, as the top was built
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "Vtrihedron_top.h"
#include "camera.hpp"
#include "golden/registers.hpp"
#include "packed_pins.hpp"

namespace trihedron::parameters {
namespace {

constexpr int kFramesPerView = 8;
constexpr std::uint32_t kTimeoutClocks = 300;  // above the idles below
constexpr std::uint64_t kHangClocks = 200000;  // above draining the widest frame

struct Instance {
  int views = 0, width = 0, height = 0, fraction_bits = 0;
};

[[noreturn]] void fail(const std::string& what, std::uint64_t expected, std::uint64_t got) {
  std::printf("differs: %s: expected %llx, got %llx\n", what.c_str(),
              static_cast<unsigned long long>(expected), static_cast<unsigned long long>(got));
  std::exit(1);
}

void require(std::uint64_t expected, std::uint64_t got, const std::string& what) {
  if (expected != got) fail(what, expected, got);
}

/// Where one view stands at its ports.
struct Port {
  std::size_t pixel = 0, beat = 0, record = 0;  ///< in the present frame
  std::size_t contour_frame = 0, vertex_frame = 0;
  bool offering = false;
};

class Bench {
 public:
  Bench(const Instance& instance, std::uint64_t seed)
      : instance_(instance),
        random_(seed),
        idle_(random_.between(0, 2)),
        stall_(random_.between(0, 2)) {
    for (int view = 0; view < instance.views; ++view) {
      cameras_.push_back(random_camera(kFramesPerView, instance.width, instance.height, random_));
      ports_.emplace_back();
    }
    top_.rst_ni = 0;
    for (int clock = 0; clock < 4; ++clock) tick();
    top_.rst_ni = 1;
  }

  void run() {
    using namespace trihedron::registers;
    require(kLimitsMaxWidth.put(static_cast<unsigned>(instance_.width)) |
                kLimitsMaxHeight.put(static_cast<unsigned>(instance_.height)) |
                kLimitsViews.put(static_cast<unsigned>(instance_.views)) |
                kLimitsFractionBits.put(static_cast<unsigned>(instance_.fraction_bits)),
            read(kLimits), "LIMITS");
    write(kFlushTimeout, kTimeoutClocks);
    std::uint64_t last_transfer = 0;
    for (std::uint64_t clock = 0; !all_out(); ++clock) {
      drive();
      if (sample()) last_transfer = clock;
      top_.clk_i = 1;
      top_.eval();
      if (clock - last_transfer > kHangClocks) fail("hang, clocks", kHangClocks, clock);
    }
    for (int view = 0; view < instance_.views; ++view) check_registers(view);
    require(0, read(kStatus + kViewStride * static_cast<unsigned>(instance_.views)),
            "register behind the last view");
  }

  std::uint64_t beats() const { return beats_; }
  std::uint64_t records() const { return records_; }

 private:
  void tick() {
    top_.clk_i = 0;
    top_.eval();
    top_.clk_i = 1;
    top_.eval();
  }

  void drive() {
    top_.clk_i = 0;
    for (int view = 0; view < instance_.views; ++view) {
      Port& port = ports_[static_cast<std::size_t>(view)];
      const auto& frames = cameras_[static_cast<std::size_t>(view)].frames;
      if (!port.offering && !frames.empty()) port.offering = random_.between(0, 3) >= idle_;
      set_field(top_.s_axis_tvalid, view, 1, port.offering);
      if (port.offering) {
        const Frame& frame = frames.front();
        const auto width = static_cast<std::size_t>(frame.width);
        set_field(top_.s_axis_tdata, 8 * view, 8, frame.pixels[port.pixel]);
        set_field(top_.s_axis_tuser, view, 1, port.pixel == 0);
        set_field(top_.s_axis_tlast, view, 1, port.pixel % width == width - 1);
      }
      set_field(top_.m_axis_contour_tready, view, 1, random_.between(0, 3) >= stall_);
    }
    top_.m_axis_vertex_tready = random_.between(0, 3) >= stall_;
    top_.eval();
  }

  /// Whether anything was transferred.
  bool sample() {
    bool transfer = false;
    for (int view = 0; view < instance_.views; ++view) {
      if (field(top_.s_axis_tvalid, view, 1) && field(top_.s_axis_tready, view, 1)) {
        transfer = true;
        take_pixel(view);
      }
      if (field(top_.m_axis_contour_tvalid, view, 1) &&
          field(top_.m_axis_contour_tready, view, 1)) {
        transfer = true;
        check_beat(view);
      }
    }
    if (top_.m_axis_vertex_tvalid && top_.m_axis_vertex_tready) {
      transfer = true;
      check_record(top_.m_axis_vertex_tdata);
    }
    return transfer;
  }

  void take_pixel(int view) {
    Port& port = ports_[static_cast<std::size_t>(view)];
    auto& frames = cameras_[static_cast<std::size_t>(view)].frames;
    port.offering = false;
    if (++port.pixel < frames.front().pixels.size()) return;
    port.pixel = 0;
    frames.pop_front();
  }

  void check_beat(int view) {
    Port& port = ports_[static_cast<std::size_t>(view)];
    const auto& all = cameras_[static_cast<std::size_t>(view)].expected;
    const std::string what = "view " + std::to_string(view) + ", frame " +
                             std::to_string(port.contour_frame) + ", contour beat " +
                             std::to_string(port.beat);
    if (port.contour_frame == all.size()) fail(what, 0, 1);
    const Expected& expected = all[port.contour_frame];
    const ContourBeat& beat = expected.features.contour[port.beat];
    const auto word = static_cast<std::uint64_t>(beat.flags) |
                      static_cast<std::uint64_t>(beat.magnitude) << 8 |
                      static_cast<std::uint64_t>(static_cast<std::uint16_t>(beat.gx)) << 24 |
                      static_cast<std::uint64_t>(static_cast<std::uint16_t>(beat.gy)) << 40;
    const auto width = static_cast<std::size_t>(expected.width);
    require(word, field(top_.m_axis_contour_tdata, 64 * view, 64), what);
    require(port.beat == 0, field(top_.m_axis_contour_tuser, view, 1), what + ", tuser");
    require(port.beat % width == width - 1, field(top_.m_axis_contour_tlast, view, 1),
            what + ", tlast");
    ++beats_;
    if (++port.beat < expected.features.contour.size()) return;
    port.beat = 0;
    ++port.contour_frame;
  }

  void check_record(std::uint64_t record) {
    const int view = static_cast<int>(record >> 2 & 15);
    if (view >= instance_.views) fail("view of a record", 0, record);
    Port& port = ports_[static_cast<std::size_t>(view)];
    const auto& all = cameras_[static_cast<std::size_t>(view)].expected;
    const std::string what = "view " + std::to_string(view) + ", frame " +
                             std::to_string(port.vertex_frame) + ", record " +
                             std::to_string(port.record);
    if (port.vertex_frame == all.size()) fail(what, 0, record);
    const Expected& expected = all[port.vertex_frame];
    const std::size_t count = expected.features.vertices.size();
    const bool end = port.record == count;
    std::uint64_t word = static_cast<std::uint64_t>(view) << 2 | (port.vertex_frame & 255) << 8;
    if (end) {
      word |= 1 | count << 16 | static_cast<std::uint64_t>(expected.status) << 48;
    } else {
      const Vertex& vertex = expected.features.vertices[port.record];
      word |= static_cast<std::uint64_t>(vertex.x) << 16 |
              static_cast<std::uint64_t>(vertex.y) << 28 |
              static_cast<std::uint64_t>(vertex.branches) << 40 |
              static_cast<std::uint64_t>(vertex.pattern) << 44 |
              static_cast<std::uint64_t>(vertex.strength) << 52;
    }
    require(word, record, what);
    require(end, top_.m_axis_vertex_tlast, what + ", tlast");
    ++records_;
    port.record = end ? 0 : port.record + 1;
    port.vertex_frame += end;
  }

  bool all_out() const {
    bool out = true;
    for (std::size_t view = 0; view < ports_.size(); ++view) {
      const std::size_t frames = cameras_[view].expected.size();
      out &= cameras_[view].frames.empty() && ports_[view].contour_frame == frames &&
             ports_[view].vertex_frame == frames;
    }
    return out;
  }

  void check_registers(int view) {
    using namespace trihedron::registers;
    const std::uint32_t base = kViewStride * static_cast<std::uint32_t>(view);
    const Camera& camera = cameras_[static_cast<std::size_t>(view)];
    const std::string name = " of view " + std::to_string(view);
    require(camera.expected.size(), read(kFrames + base), "FRAMES" + name);
    require(camera.events, read(kStatus + base), "STATUS" + name);
    write(kStatus + base, camera.events);
    require(0, read(kStatus + base), "STATUS, cleared," + name);
  }

  void write(std::uint32_t address, std::uint32_t data) {
    top_.s_axil_awvalid = top_.s_axil_wvalid = top_.s_axil_bready = 1;
    top_.s_axil_awaddr = address;
    top_.s_axil_wdata = data;
    top_.s_axil_wstrb = 15;
    for (int clock = 0; clock < 8; ++clock) {
      const bool taken = top_.s_axil_awready && top_.s_axil_wready;
      tick();
      if (taken) top_.s_axil_awvalid = top_.s_axil_wvalid = 0;
    }
  }

  std::uint32_t read(std::uint32_t address) {
    std::uint32_t data = 0;
    top_.s_axil_arvalid = top_.s_axil_rready = 1;
    top_.s_axil_araddr = address;
    for (int clock = 0; clock < 8; ++clock) {
      const bool taken = top_.s_axil_arready;
      if (top_.s_axil_rvalid) data = top_.s_axil_rdata;
      tick();
      if (taken) top_.s_axil_arvalid = 0;
    }
    return data;
  }

  Instance instance_;
  sim::Random random_;
  int idle_, stall_;  ///< quarters of the clocks
  Vtrihedron_top top_;
  std::vector<Camera> cameras_;
  std::vector<Port> ports_;
  std::uint64_t beats_ = 0, records_ = 0;
};

}  // namespace
}  // namespace trihedron::parameters

int main(int argc, char** argv) {
  using namespace trihedron::parameters;
  if (argc != 6) return 2;
  const Instance instance{std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]),
                          std::atoi(argv[4])};
  Verilated::fatalOnVpiError(false);
  std::uint64_t beats = 0, records = 0;
  for (int seed = 1; seed <= std::atoi(argv[5]); ++seed) {
    const auto bench = std::make_unique<Bench>(instance, static_cast<std::uint64_t>(seed));
    bench->run();
    beats += bench->beats();
    records += bench->records();
  }
  std::printf("Views %d, %d x %d px, FractionBits %d: equal, %llu beats, %llu records\n",
              instance.views, instance.width, instance.height, instance.fraction_bits,
              static_cast<unsigned long long>(beats), static_cast<unsigned long long>(records));
  return beats == 0 || records == 0 ? 1 : 0;
}
