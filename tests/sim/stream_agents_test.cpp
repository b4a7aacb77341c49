// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "sim/stream_driver.hpp"
#include "sim/stream_monitor.hpp"
#include "sim/test_frames.hpp"

using namespace trihedron::sim;

TEST_CASE("an offered pixel stays as it is until it is accepted") {
  StreamDriver driver({0.5, 3}, 7);
  Random random(7);
  for (const WireLinePtr& line : make_wire_lines(frame_of(polygons(9, 5, 7)))) driver.queue(line);
  driver.close();
  HandshakeRule rule;
  int accepted = 0, idles = 0;
  while (!driver.finished()) {
    driver.present();
    const bool ready = random.chance(0.5);
    CHECK(rule.keep(driver.valid(), ready, driver.data(), driver.user() + 2u * driver.last()));
    idles += !driver.valid();
    if (driver.valid() && ready) {
      CHECK(driver.accept() == (accepted == 0));
      ++accepted;
    }
  }
  CHECK(accepted == 45);
  CHECK(idles > 0);
}

TEST_CASE("a driver without idles offers a pixel at every clock") {
  StreamDriver driver({}, 1);
  driver.queue(make_wire_lines(frame_of(polygons(30, 1, 1))).front());
  for (int clock = 0; clock < 30; ++clock) {
    driver.present();
    REQUIRE(driver.valid());
    CHECK(driver.last() == (clock == 29));
    driver.accept();
  }
  CHECK(driver.starving());
}

TEST_CASE("the handshake rule notices a withdrawn and a changed beat") {
  HandshakeRule rule;
  CHECK(rule.keep(true, false, 5, 0));
  CHECK(rule.keep(true, true, 5, 0));
  CHECK(rule.keep(true, false, 6, 0));  // taken before: may change
  CHECK_FALSE(rule.keep(true, false, 7, 0));
  CHECK_FALSE(rule.keep(false, false, 7, 0));
  CHECK(rule.keep(false, true, 9, 1));
}

TEST_CASE("the contour monitor cuts beats into lines and marks stray starts") {
  ContourMonitor monitor({}, 1);
  for (int beat = 0; beat < 6; ++beat) {
    monitor.ready();
    monitor.sample(true, static_cast<std::uint64_t>(beat), beat == 0 || beat == 4, beat % 3 == 2,
                   10);
  }
  const auto lines = monitor.take_lines();
  REQUIRE(lines.size() == 2);
  CHECK(lines[0]->start);
  CHECK(lines[0]->beats == std::vector<std::uint64_t>{0, 1, 2});
  CHECK_FALSE(lines[1]->start);
  CHECK(lines[1]->stray_start == 1);
}
