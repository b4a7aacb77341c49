// SPDX-License-Identifier: Apache-2.0
#include "io/library.hpp"

#include <catch2/catch.hpp>

#include "io/file.hpp"
#include "io/mesh.hpp"
#include "recognition/shapes.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

std::string library_error(const Scratch& scratch) {
  return error_of([&] { read_library(scratch.path()); });
}

/// The mesh as OBJ, with quads where `quads` (a block's six faces) and normals.
const char* const kBlockObj =
    "v 0 0 0\nv 40 0 0\nv 40 50 0\nv 0 50 0\nv 0 0 60\nv 40 0 60\nv 40 50 60\nv 0 50 60\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const char* const kBlockOff =
    "OFF\n8 6 0\n0 0 0\n40 0 0\n40 50 0\n0 50 0\n0 0 60\n40 0 60\n40 50 60\n0 50 60\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

std::string stl(const Mesh& mesh) {
  std::string text = "solid part\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (int v : t) {
      const auto& x = mesh.vertices[v];
      text += "vertex " + std::to_string(x.x()) + " " + std::to_string(x.y()) + " " +
              std::to_string(x.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

}  // namespace

TEST_CASE("the bundled library has ten named models by id") {
  const std::vector<Model> models = read_library(TRIHEDRON_TESTVECTORS "/models10");
  REQUIRE(models.size() == 10);
  for (int i = 0; i < 10; ++i) CHECK(models[i].id == i + 1);
  CHECK(models[0].name == "gable_block");
  CHECK(models[9].name == "u_channel");
}

TEST_CASE("the same block reads the same from PLY, OBJ, STL and OFF") {
  const Scratch scratch;
  const Mesh block = shapes::block(40, 50, 60);
  write_ply(scratch / "a.ply", block);
  scratch.write("a.obj", kBlockObj);
  scratch.write("a.off", kBlockOff);
  scratch.write("a.stl", stl(block));
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
    const Model model = build_model(1, name, read_mesh(scratch / name));
    INFO(name);
    CHECK(model.surfaces.size() == 6);
    CHECK(model.mesh.vertices.size() == 8);
    CHECK(model.diameter == Approx(std::sqrt(7700.0)));
    CHECK(model.symmetries.size() == 3);
  }
}

TEST_CASE("meshes with other names get free ids in name order") {
  const Scratch scratch;
  write_ply(scratch / "obj_000004.ply", shapes::block(40, 50, 60));
  write_ply(scratch / "wedge.ply", shapes::prism({{0, 0}, {60, 0}, {0, 40}}, 30));
  write_ply(scratch / "hexagon.ply", shapes::regular_prism(6, 30, 50));
  const std::vector<Model> models = read_library(scratch.path());
  REQUIRE(models.size() == 3);
  CHECK(models[0].id == 4);
  CHECK(models[1].id == 5);
  CHECK(models[1].name == "hexagon");
  CHECK(models[2].id == 6);
  CHECK(models[2].name == "wedge");
}

TEST_CASE("written and read meshes are equal to single precision") {
  const Scratch scratch;
  const Mesh mesh = shapes::regular_prism(7, 33.3, 21.7);
  write_ply(scratch / "m.ply", mesh);
  const Mesh read = read_mesh(scratch / "m.ply");
  REQUIRE(read.triangles.size() == mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      CHECK((read.vertices[read.triangles[i][k]] - mesh.vertices[mesh.triangles[i][k]]).norm() <
            1e-5);
}

TEST_CASE("a library without meshes and unreadable meshes are named") {
  const Scratch scratch;
  CHECK_THAT(library_error(scratch), Contains("no meshes in this folder"));
  CHECK_THAT(error_of([&] { read_library(scratch / "none"); }), Contains("none: no such folder"));
  CHECK_THAT(error_of([&] { read_mesh(scratch / "a.step"); }), Contains("expected a .ply"));
  CHECK_THAT(error_of([&] { read_mesh(scratch / "a.ply"); }), Contains("a.ply: no such file"));
  for (const char* name : {"a.ply", "a.obj", "a.stl", "a.off"}) {
    scratch.write(name, "no mesh\n");
    CHECK_THAT(error_of([&] { build_model(1, name, read_mesh(scratch / name)); }), Contains(name));
  }
}

TEST_CASE("a mesh that is no polyhedron is named with its file and edge") {
  const Scratch scratch;
  Mesh open = shapes::block(40, 50, 60);
  open.triangles.pop_back();
  write_ply(scratch / "obj_000001.ply", open);
  CHECK_THAT(library_error(scratch), Contains("obj_000001.ply: not closed: the edge from ("));
}

TEST_CASE("models with one id, or one shape twice, are refused") {
  const Scratch scratch;
  write_ply(scratch / "obj_000001.ply", shapes::block(40, 50, 60));
  scratch.write("obj_1.off", kBlockOff);
  CHECK_THAT(library_error(scratch), Contains("model 1 is also obj_000001.ply"));
  std::filesystem::rename(scratch / "obj_1.off", scratch / "obj_2.off");
  CHECK_THAT(library_error(scratch), Contains("models 1 (obj_000001) and 2 (obj_2) are the same"));
}

TEST_CASE("a diameter that disagrees with models_info.json betrays a wrong unit") {
  const Scratch scratch;
  write_ply(scratch / "obj_000003.ply", shapes::block(40, 50, 60));
  scratch.write("models_info.json", "{\"3\": {\"diameter\": 0.08775}}");
  CHECK_THAT(library_error(scratch),
             Contains("models_info.json: 3.diameter: 0.08775 mm, but the mesh of model 3 is 87.7"));
}
