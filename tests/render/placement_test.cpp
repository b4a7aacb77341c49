// SPDX-License-Identifier: Apache-2.0
#include "render/placement.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "io/library.hpp"
#include "recognition/shapes.hpp"
#include "render/contact.hpp"
#include "render/stable_pose.hpp"

using namespace trihedron;
using namespace trihedron::render;

namespace {

constexpr double kTouch_mm = 0.02;  // bodies that touch are kept this far apart at most

Body block_at(double x, double y, double z, const Eigen::Vector3d& at) {
  static std::vector<Model> models;
  models.reserve(16);
  models.push_back(build_model(1, "block", shapes::block(x, y, z)));
  return make_body({&models.back(), {Eigen::Matrix3d::Identity(), at}, 1});
}

double lowest(const Body& body) {
  double z = body.vertices[0].z();
  for (const Eigen::Vector3d& v : body.vertices) z = std::min(z, v.z());
  return z;
}

double highest(const Body& body) {
  double z = body.vertices[0].z();
  for (const Eigen::Vector3d& v : body.vertices) z = std::max(z, v.z());
  return z;
}

std::vector<Body> place(const PlacementOptions& options, std::uint64_t seed,
                        const std::string& rig_name) {
  static const std::vector<Model> library = read_library(TRIHEDRON_TESTVECTORS "/models10");
  Random random(seed);
  RigOptions rig;
  rig.name = rig_name;
  const std::vector<Camera> cameras = make_rig(rig, random);
  std::vector<Body> bodies;
  for (const PlacedObject& object :
       place_objects(library, cameras, rig_field(rig_name), options, random)) {
    CHECK(object.world_from_model.R.determinant() == Approx(1));
    bodies.push_back(make_body(object));
    for (const Camera& camera : cameras)
      for (const Eigen::Vector3d& v : bodies.back().vertices) {
        const Eigen::Vector2d p = camera.project(v);
        const bool inside = p.x() >= 4 && p.y() >= 4 && p.x() <= camera.width_px - 5 &&
                            p.y() <= camera.height_px - 5;
        if (!inside) FAIL("a vertex lies outside the image");
      }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = i + 1; j < bodies.size(); ++j)
      CHECK_FALSE(interpenetrate(bodies[i], bodies[j]));
  return bodies;
}

}  // namespace

TEST_CASE("the centre of mass of a wedge is that of its triangle") {
  const Mesh wedge = shapes::prism({{0, 0}, {30, 0}, {0, 60}}, 12);
  CHECK(centre_of_mass(wedge).isApprox(Eigen::Vector3d(10, 20, 6), 1e-12));
}

TEST_CASE("a block rests on each of its six faces") {
  const std::vector<StablePose> poses = stable_poses(shapes::block(20, 30, 40), 0.1);
  CHECK(poses.size() == 6);
}

TEST_CASE("a thin rod does not stand on its ends") {
  // 4 mm wide, 100 mm high: it falls at atan(2 / 50), 2.3 degrees.
  CHECK(stable_poses(shapes::block(4, 4, 100), 0.1).size() == 4);
  CHECK(stable_poses(shapes::block(4, 4, 100), 0.03).size() == 6);
}

TEST_CASE("a body rests on the faces of its hull where the solid itself has none") {
  // A frame on its side touches with its outer walls; its hull is a block.
  CHECK(stable_poses(shapes::frame(60, 30, 40), 0.1).size() == 6);
}

TEST_CASE("blocks interpenetrate when they overlap, hold one another, or cross like a plus") {
  const Body a = block_at(40, 40, 40, {0, 0, 0});
  CHECK(interpenetrate(a, block_at(40, 40, 40, {20, 20, 20})));
  CHECK(interpenetrate(a, block_at(10, 10, 10, {15, 15, 15})));
  CHECK(interpenetrate(a, block_at(80, 10, 10, {-20, 15, 15})));
  CHECK_FALSE(interpenetrate(a, block_at(40, 40, 40, {40.01, 0, 0})));
  CHECK_FALSE(interpenetrate(a, block_at(40, 40, 40, {0, 0, 40.001})));
}

TEST_CASE("a peg in a frame's hole does not interpenetrate it") {
  const Model frame = build_model(2, "frame", shapes::frame(60, 30, 20));
  const Body ring = make_body({&frame, {}, 1});
  CHECK_FALSE(interpenetrate(ring, block_at(20, 20, 80, {-10, -10, -20})));
  CHECK(interpenetrate(ring, block_at(20, 20, 80, {-10, -10 + 6, -20})));
}

TEST_CASE("the contact of two crossed blocks is their common rectangle") {
  const Body low = block_at(60, 20, 10, {0, 0, 0}), high = block_at(20, 60, 10, {20, -20, 10});
  const auto outline = contact_outline(low, high, 10);
  CHECK(outline.size() == 4);
  CHECK(depth_inside(outline, {30, 10}) == Approx(10));
  CHECK(depth_inside(outline, {15, 10}) < 0);
  CHECK(contact_outline(low, block_at(20, 60, 10, {80, 0, 10}), 10).empty());
}

TEST_CASE("objects that stand apart rest on the table") {
  PlacementOptions options;
  options.objects = 2;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const std::vector<Body> bodies = place(options, seed, "paper");
    CHECK(lowest(bodies[0]) == Approx(0).margin(1e-9));
    CHECK(lowest(bodies[1]) == Approx(0).margin(1e-9));
    CHECK(gap_in_plan(bodies[0], bodies[1]) >= options.gap_mm);
  }
}

TEST_CASE("a stacked object rests on the top of the first") {
  PlacementOptions options;
  options.objects = 3;
  options.stacked = true;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    std::vector<Body> bodies = place(options, seed, "hd");
    const double top = highest(bodies[0]), gap = lowest(bodies[1]) - top;
    CHECK(gap == Approx(0).margin(kTouch_mm));
    for (Eigen::Vector3d& v : bodies[1].vertices) v.z() -= gap;
    const auto contact = contact_outline(bodies[0], bodies[1], top);
    CHECK(depth_inside(contact, bodies[1].mass.head<2>()) > 0);
  }
}

TEST_CASE("a leaning object touches the table and the other object") {
  PlacementOptions options;
  options.objects = 2;
  options.leaning = true;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const std::vector<Body> bodies = place(options, seed, "hd");
    CHECK(lowest(bodies[1]) == Approx(0).margin(kTouch_mm));
    bool touches = false;
    for (int k = 0; k < 16 && !touches; ++k) {
      const double angle = k * 6.283185307179586 / 16;
      Body nudged = bodies[1];
      for (Eigen::Vector3d& v : nudged.vertices)
        v += 2 * kTouch_mm * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
      touches = interpenetrate(nudged, bodies[0]);
    }
    CHECK(touches);
  }
}

TEST_CASE("a field without room for the objects says so") {
  PlacementOptions options;
  options.objects = 9;
  CHECK_THROWS_WITH(place(options, 1, "paper"), Catch::Contains("no room for 9 objects"));
}

TEST_CASE("more different objects than models are refused") {
  PlacementOptions options;
  options.objects = 11;
  CHECK_THROWS_WITH(place(options, 1, "hd"), Catch::Contains("library of 10 models"));
}
