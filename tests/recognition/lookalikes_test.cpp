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
  // The mirror image fits a block of these sides in four ways.
  CHECK(alike.mirrored_onto.size() == 4);
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

TEST_CASE("symmetries are no lookalikes") {
  CHECK(find_lookalikes(model_of(shapes::block(60, 50, 40))).turned.empty());
  CHECK(find_lookalikes(model_of(shapes::regular_prism(6, 40, 30))).turned.empty());
}
