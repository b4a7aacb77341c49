// SPDX-License-Identifier: Apache-2.0
#include "recognition/regions.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "recognition/paper_scenes.hpp"
#include "recognition/region_boundary.hpp"

using namespace trihedron;
using Eigen::Vector2d;

namespace {

/// Features drawn by hand: '#' is contour; no gradient, so points stay on pixel centres.
ViewFeatures drawing(int width, int height) {
  ViewFeatures f;
  f.width = width;
  f.height = height;
  f.contour.resize(static_cast<std::size_t>(width * height));
  return f;
}

void put(ViewFeatures* f, int x, int y, bool on = true) {
  f->contour[static_cast<std::size_t>(y * f->width + x)].flags = on ? kContour : 0;
}

void draw_box(ViewFeatures* f, int x0, int y0, int x1, int y1) {
  for (int x = x0; x <= x1; ++x) put(f, x, y0), put(f, x, y1);
  for (int y = y0; y <= y1; ++y) put(f, x0, y), put(f, x1, y);
}

double distance_to_corners(const ImagePolygon& polygon, const Vector2d& p) {
  double nearest = 1e9;
  for (const Vector2d& c : polygon) nearest = std::min(nearest, (c - p).norm());
  return nearest;
}

}  // namespace

TEST_CASE("a closed contour bounds one region with corners on its pixels") {
  ViewFeatures f = drawing(60, 50);
  draw_box(&f, 10, 12, 40, 33);
  const auto regions = find_regions(f);
  REQUIRE(regions.size() == 1);
  REQUIRE(regions[0].outer.size() == 4);
  for (const Vector2d& c : {Vector2d(10, 12), Vector2d(40, 12), Vector2d(40, 33), Vector2d(10, 33)})
    CHECK(distance_to_corners(regions[0].outer, c) < 1e-6);
  CHECK(regions[0].area_px2 == Approx(30 * 21));
  CHECK(signed_area(regions[0].outer) < 0);  // counter-clockwise on the screen
}

TEST_CASE("what reaches the image border is background") {
  ViewFeatures f = drawing(60, 50);
  draw_box(&f, 20, 12, 59, 33);  // closed by the border only: the right side runs along it
  for (int y = 12; y <= 33; ++y) put(&f, 59, y, false);
  CHECK(find_regions(f).empty());
  CHECK(find_regions(drawing(60, 50)).empty());
}

TEST_CASE("gaps of up to two pixels are bridged, wider ones are not") {
  for (int gap = 1; gap <= 3; ++gap) {
    ViewFeatures f = drawing(60, 50);
    draw_box(&f, 10, 12, 40, 33);
    for (int i = 0; i < gap; ++i) put(&f, 25 + i, 12, false);
    CHECK(find_regions(f).size() == (gap <= 2 ? 1 : 0));
  }
}

TEST_CASE("a broken weak edge goes on along the ridge of the gradient") {
  ViewFeatures f = drawing(60, 50);
  draw_box(&f, 10, 10, 40, 40);
  for (int y = 11; y < 40; ++y) {
    ContourBeat& beat = f.contour[static_cast<std::size_t>(y * f.width + 25)];
    beat.gx = 20;
    beat.magnitude = 20;
    if (y < 18 || y > 32) beat.flags = kContour;
  }
  CHECK(find_regions(f).size() == 2);
  for (int y = 22; y < 28; ++y) f.contour[static_cast<std::size_t>(y * f.width + 25)].magnitude = 2;
  const auto regions = find_regions(f);  // the ridge ends: one region in pieces
  REQUIRE(regions.size() == 1);
  CHECK(regions[0].outer.size() == 4);
  CHECK(regions[0].loose_px > 5);
}

TEST_CASE("a loose line inside a region neither splits nor bends it") {
  ViewFeatures f = drawing(60, 50);
  draw_box(&f, 10, 12, 40, 33);
  for (int y = 13; y < 22; ++y) put(&f, 25, y);
  const auto regions = find_regions(f);
  REQUIRE(regions.size() == 1);
  CHECK(regions[0].outer.size() == 4);
  CHECK(regions[0].area_px2 == Approx(30 * 21));
}

TEST_CASE("an inner contour makes a hole in one region and the outside of another") {
  ViewFeatures f = drawing(80, 70);
  draw_box(&f, 10, 10, 60, 55);
  draw_box(&f, 25, 22, 45, 40);
  const auto regions = find_regions(f);
  REQUIRE(regions.size() == 2);
  REQUIRE(regions[0].holes.size() == 1);
  CHECK(signed_area(regions[0].holes[0]) > 0);
  CHECK(regions[0].area_px2 == Approx(50 * 45 - 20 * 18));
  CHECK(regions[1].holes.empty());
  CHECK(regions[1].area_px2 == Approx(20 * 18));
}

TEST_CASE("specks and slits narrower than a window are no regions") {
  ViewFeatures f = drawing(60, 50);
  draw_box(&f, 10, 10, 14, 14);  // 9 pixels inside
  draw_box(&f, 20, 10, 22, 45);  // one pixel wide inside
  CHECK(find_regions(f).empty());
}

TEST_CASE("a contour point moves to the maximum of the parabola through three magnitudes") {
  ViewFeatures f = drawing(20, 20);
  for (const double shift : {-0.4, 0.0, 0.3}) {
    for (int x = 8; x <= 12; ++x) {
      ContourBeat& beat = f.contour[static_cast<std::size_t>(10 * f.width + x)];
      const double d = x - 10 - shift;
      beat.magnitude = static_cast<std::uint16_t>(1000 - 100 * d * d);
      beat.gx = 100;
      beat.flags = x == 10 ? kContour : 0;
    }
    // magnitudes are rounded to 1 of a bend of 200: 1 / 200 px
    CHECK(subpixel_contour(f, 10, 10).x() == Approx(10 + shift).margin(0.005));
  }
}

TEST_CASE("corners of a turned block are found to a quarter of a pixel in all views") {
  const std::vector<Camera> cameras = paper_scenes::exact_views();
  const Model block = rigs::block(60, 50, 40);
  const Transform pose = paper_scenes::standing(25, 40);
  const auto truth = paper_scenes::regions_of(cameras, block, pose);
  for (std::size_t v = 0; v < 3; ++v) {
    const auto regions = find_regions(rigs::features_of(cameras[v], {{&block, pose}}));
    INFO("view " + std::to_string(v));
    REQUIRE(regions.size() == truth[v].size());
    for (const Region& region : regions) REQUIRE(region.outer.size() == 4);
    for (const Region& expected : truth[v]) {
      for (const Vector2d& corner : expected.outer) {
        double nearest = 1e9;
        for (const Region& r : regions)
          nearest = std::min(nearest, distance_to_corners(r.outer, corner));
        CHECK(nearest < 0.25);
      }
    }
  }
}
