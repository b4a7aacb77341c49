// SPDX-License-Identifier: Apache-2.0
#include "recognition/lookalikes.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "recognition/shapes.hpp"
#include "recognition/symmetry.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

Model model_of(const Mesh& mesh) { return build_model(1, "m", mesh); }

Model cut_block() { return model_of(shapes::cut_block()); }

}  // namespace

TEST_CASE("a mirror image is the solid that meshing the mirrored points gives") {
  const Model model = cut_block();
  Mesh mesh = model.mesh;
  for (Vector3d& v : mesh.vertices) v.x() = -v.x();
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  const Model mirrored = mirror_image(model);
  CHECK(congruences(mirrored, model_of(mesh)).size() == 1);
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    CHECK(mirrored.edges[e].convex == model.edges[e].convex);
  }
}

TEST_CASE("a shape that is its own mirror image has none to be taken for") {
  CHECK_FALSE(find_lookalikes(model_of(shapes::block(60, 50, 40))).mirrored.has_value());
}

TEST_CASE("a block with a cut corner looks like its mirror image, whichever corner that has cut") {
  const Lookalikes alike = find_lookalikes(cut_block());
  REQUIRE(alike.mirrored.has_value());
  // The mirror image fits a block of these sides in four ways; others share less.
  REQUIRE(alike.mirrored_onto.size() >= 4);
  const Model model = cut_block();
  for (int k = 0; k < 4; ++k) {
    int corners = 0;
    for (const Eigen::Vector3d& v : alike.mirrored->mesh.vertices) {
      for (const Eigen::Vector3d& w : model.mesh.vertices) {
        corners += (alike.mirrored_onto[k] * v - w).norm() < 0.02 * model.diameter;
      }
    }
    CHECK(corners >= 6);  // of the block's eight, one is cut in each
  }
}

TEST_CASE("a skew frustum is taken for its mirror image on the same base") {
  Mesh mesh = shapes::block(60, 50, 40);
  mesh.vertices[4] = {20, 15, 40};
  mesh.vertices[5] = {50, 15, 40};
  mesh.vertices[6] = {50, 30, 40};
  mesh.vertices[7] = {20, 30, 40};
  const Lookalikes alike = find_lookalikes(model_of(mesh));
  REQUIRE(alike.mirrored.has_value());
  CHECK(alike.mirrored_onto.size() >= 2);  // either way round
}

TEST_CASE("a block with a cut corner looks like itself turned by 180 degrees") {
  const Model model = cut_block();
  const Lookalikes alike = find_lookalikes(model);
  CHECK(alike.turned.size() == 3);
  for (const Transform& turn : alike.turned) {
    CHECK(turn.R.determinant() == Approx(1).margin(1e-9));  // rounding
    CHECK_FALSE(is_identity(turn, model));
  }
}

TEST_CASE("a shape just fits into its block, and a block has none but itself") {
  const Model model = cut_block();
  const Lookalikes alike = find_lookalikes(model);
  REQUIRE(alike.block.has_value());
  CHECK(congruences(*alike.block, model_of(shapes::block(60, 50, 40))).size() >= 1);
  for (const Surface& surface : alike.block->surfaces) {
    double outermost = -1e9;
    for (const Vector3d& v : model.mesh.vertices) {
      outermost = std::max(outermost, surface.normal.dot(v) - surface.offset);
    }
    CHECK(outermost == Approx(0).margin(1e-9));  // rounding
  }
  CHECK_FALSE(find_lookalikes(model_of(shapes::block(60, 50, 40))).block.has_value());
}

TEST_CASE("symmetries are no lookalikes") {
  CHECK(find_lookalikes(model_of(shapes::block(60, 50, 40))).turned.empty());
  CHECK(find_lookalikes(model_of(shapes::regular_prism(6, 40, 30))).turned.empty());
}
