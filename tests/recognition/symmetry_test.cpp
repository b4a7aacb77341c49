// SPDX-License-Identifier: Apache-2.0
#include "recognition/symmetry.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/mesh.hpp"
#include "recognition/shapes.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

Model model_of(const Mesh& mesh) { return build_model(1, "m", mesh); }

/// Largest distance between the images of the model's vertices under two motions, mm.
double difference(const Model& model, const Transform& a, const Transform& b) {
  double largest = 0;
  for (const Vector3d& x : model.mesh.vertices) largest = std::max(largest, (a * x - b * x).norm());
  return largest;
}

}  // namespace

TEST_CASE("the symmetries of regular shapes are counted right") {
  CHECK(model_of(shapes::block(40, 40, 40)).symmetries.size() == 23);
  CHECK(model_of(shapes::block(40, 40, 60)).symmetries.size() == 7);
  CHECK(model_of(shapes::block(40, 50, 60)).symmetries.size() == 3);
  CHECK(model_of(shapes::regular_prism(5, 40, 30)).symmetries.size() == 9);
  CHECK(model_of(shapes::frame(80, 30, 20)).symmetries.size() == 7);
}

TEST_CASE("a shape without symmetry has none, whatever its mirror image looks like") {
  const Model l =
      model_of(shapes::prism({{20, 20}, {20, 50}, {0, 50}, {0, 0}, {60, 0}, {60, 20}}, 30));
  CHECK(l.symmetries.empty());
}

TEST_CASE("symmetries are proper rotations that form a group") {
  const Model model = model_of(shapes::regular_prism(6, 40, 30));
  REQUIRE(model.symmetries.size() == 11);
  std::vector<Transform> group = model.symmetries;
  group.emplace_back();
  for (const Transform& a : group) {
    CHECK(a.R.determinant() == Approx(1));
    for (const Transform& b : group) {
      int found = 0;
      for (const Transform& c : group) found += difference(model, a * b, c) < 1e-6 ? 1 : 0;
      CHECK(found == 1);
    }
  }
}

TEST_CASE("one part in a hundred longer is another shape, one in ten thousand the same") {
  const Model block = model_of(shapes::block(50, 50, 60));
  CHECK(model_of(shapes::block(50.5, 50, 60)).symmetries.size() == 3);
  CHECK(model_of(shapes::block(50.005, 50, 60)).symmetries.size() == 7);
  CHECK(congruences(block, model_of(shapes::block(50.5, 50, 60))).empty());
}

TEST_CASE("a moved copy is found with its motion, a mirrored one is not") {
  // A sheared prism over an irregular polygon: no symmetry, and chiral.
  Mesh mesh = shapes::prism({{0, 0}, {60, 0}, {45, 35}, {0, 25}}, 30);
  for (Vector3d& x : mesh.vertices) x.x() += 0.5 * x.z();
  Transform motion;
  motion.R = Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  motion.t = {5, -7, 11};
  Mesh moved = mesh, mirrored = mesh;
  for (Vector3d& x : moved.vertices) x = motion * x;
  for (Vector3d& x : mirrored.vertices) x.z() = -x.z();
  for (auto& t : mirrored.triangles) std::swap(t[0], t[1]);
  const auto found = congruences(model_of(mesh), model_of(moved));
  REQUIRE(found.size() == 1);
  CHECK(difference(model_of(mesh), found[0], motion) < 1e-9);
  CHECK(congruences(model_of(mesh), model_of(mirrored)).empty());
}

TEST_CASE("the symmetries of the ten bundled models are those that their makers list") {
  const auto info =
      nlohmann::json::parse(std::ifstream(TRIHEDRON_TESTVECTORS "/models10/models_info.json"));
  constexpr double kDigitsMm = 2e-3;  // rotations are listed with six digits, x 100 mm
  for (int id = 1; id <= 10; ++id) {
    char file[32];
    std::snprintf(file, sizeof file, "/obj_%06d.ply", id);
    const Model model =
        build_model(id, file, read_mesh(std::string(TRIHEDRON_TESTVECTORS "/models10") + file));
    const auto& entry = info.at(std::to_string(id));
    const auto listed = entry.value("symmetries_discrete", std::vector<std::vector<double>>());
    INFO(file);
    CHECK(model.diameter == Approx(entry.at("diameter").get<double>()).margin(1e-4));
    REQUIRE(model.symmetries.size() == listed.size());
    for (const auto& m : listed) {
      Transform expected;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) expected.R(r, c) = m[4 * r + c];
        expected.t[r] = m[4 * r + 3];
      }
      int found = 0;
      for (const Transform& s : model.symmetries)
        found += difference(model, s, expected) < kDigitsMm ? 1 : 0;
      CHECK(found == 1);
    }
  }
}
