// SPDX-License-Identifier: Apache-2.0
#include "recognition/corner_index.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSame = 1e-3;  // directions that share a shape

/// All corners of an index whose first edge is between `low` and `high` mm long.
std::vector<std::size_t> all_between(const CornerIndex& index, double low, double high) {
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < index.shapes().size(); ++s) {
    const auto [first, last] = index.corners_between(s, low, high);
    for (std::size_t i = first; i < last; ++i) out.push_back(i);
  }
  return out;
}

}  // namespace

TEST_CASE("the index keeps one of the corners that a symmetry maps onto each other") {
  const CornerIndex index({rigs::block(60, 45, 35)});
  // 8 vertices with 6 ordered pairs of edges, four proper symmetries.
  CHECK(index.size() == 12);
  CHECK(all_between(index, 0, 100).size() == 12);
  CHECK(all_between(index, 59, 61).size() == 4);
  CHECK(all_between(index, 61, 90).empty());
}

TEST_CASE("corners of all blocks share two shapes, a right-handed and a left-handed one") {
  const CornerIndex index({rigs::block(60, 45, 35), rigs::block(50, 40, 20)});
  REQUIRE(index.shapes().size() == 2);
  for (const CornerShape& shape : index.shapes()) {
    CHECK(shape.end - shape.begin == 12);
    CHECK(std::abs(shape.cosine) < kSame);
    CHECK(std::abs(std::abs(shape.third.z()) - 1) < kSame);
    CHECK(shape.longest.first == Approx(60));
  }
  CHECK(index.shapes_between(kPi / 2 - 0.1, kPi / 2 + 0.1) ==
        std::pair<std::size_t, std::size_t>(0, 2));
  const auto [first, last] = index.shapes_between(0.5, 1.0);
  CHECK(first == last);
}

TEST_CASE("a corner's frame and lengths lead back to its model's edges") {
  const Model model = rigs::l_bracket();
  const CornerIndex index({model});
  REQUIRE(index.size() > 20);
  for (const CornerShape& shape : index.shapes()) {
    for (std::size_t i = shape.begin; i < shape.end; ++i) {
      const ModelCorner& c = index.corner(i);
      const CornerLengths& l = index.lengths(i);
      const Vector3d directions[3] = {
          Vector3d::UnitX(), {shape.cosine, shape.sine, 0}, shape.third};
      const float lengths[3] = {l.first, l.second, l.third};
      for (int k = 0; k < 3; ++k) {
        const Vector3d end = c.position + lengths[k] * (c.model_from_corner * directions[k]);
        const auto near = [&](const Vector3d& v) { return (v - end).norm() < kSame * 100; };
        INFO("corner " << i << " edge " << k);
        CHECK(std::any_of(model.mesh.vertices.begin(), model.mesh.vertices.end(), near));
      }
    }
  }
}
