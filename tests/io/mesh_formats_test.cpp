// SPDX-License-Identifier: Apache-2.0
// STL and OBJ; PLY and OFF are in foreign_mesh_test.cpp.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "io/mesh.hpp"
#include "io/polygons.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

constexpr float kCorners[4][3] = {{0, 0, 0}, {40, 0, 0}, {0, 50, 0}, {0, 0, 60}};
constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

std::string binary_stl() {
  std::string bytes(80, ' ');
  const auto add = [&bytes](const void* value, std::size_t size) {
    bytes.append(static_cast<const char*>(value), size);
  };
  const std::uint32_t facets = 4;
  add(&facets, 4);
  for (const auto& face : kFaces) {
    const float normal[3] = {};
    add(normal, sizeof normal);
    for (const int corner : face) add(kCorners[corner], sizeof kCorners[corner]);
    add("\0", 2);
  }
  return bytes;
}

std::string ascii_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& face : kFaces) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const int corner : face) {
      text += "   vertex";
      for (const float x : kCorners[corner]) text += " " + std::to_string(x);
      text += "\r\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid\n";
}

}  // namespace

TEST_CASE("a tetrahedron is the same model from binary and ASCII STL and from OBJ") {
  const Scratch scratch;
  const std::string obj =
      "# by hand\nmtllib none.mtl\no t\nv 0 0 0\nv 40 0 0\nv 0 50 0\nv 0 0 60 1\nvn 0 0 1\n"
      "usemtl red\nf 1 3 2\nf 1//1 2//1 4//1\ns off\nf -3/1/1 -2/1/1 -1/1/1\nf 3 1 4\n";
  const struct {
    const char* name;
    std::string bytes;
  } files[] = {{"a.stl", binary_stl()}, {"b.stl", ascii_stl()}, {"c.obj", obj}};
  for (const auto& [name, bytes] : files) {
    INFO(name);
    const Model model = build_model(1, name, read_mesh(scratch.write(name, bytes)));
    CHECK(model.surfaces.size() == 4);
    CHECK(model.edges.size() == 6);
    CHECK(model.diameter == Approx(std::hypot(50, 60)));
  }
}

TEST_CASE("broken STL and OBJ files are named with what is wrong") {
  const Scratch scratch;
  const auto message = [&](const std::string& name, const std::string& text) {
    return error_of([&] { read_mesh(scratch.write(name, text)); });
  };
  const std::string cut = binary_stl().substr(0, 200);
  CHECK_THAT(message("a.stl", cut), Contains("a.stl: neither begins with \"solid\" nor"));
  CHECK_THAT(message("a.stl", "solid\nvertex 0 0\n"), Contains("line 2: a vertex without three"));
  CHECK_THAT(message("a.stl", "solid\nvertex 0 0 0\nendloop\n"), Contains("line 3: a loop that"));
  CHECK_THAT(message("a.stl", "solid\nvertex 0 0 0\n"), Contains("the file ends too early"));
  CHECK_THAT(message("a.obj", "v 0 0 x\n"), Contains("a.obj: line 1: \"x\" is no number"));
  CHECK_THAT(message("a.obj", "v 0 0 0\nf 1 1 2\n"), Contains("line 2: \"2\" is no vertex so far"));
  CHECK_THAT(message("a.obj", "v 0 0 0\nf 1 1 0\n"), Contains("\"0\" is no vertex so far"));
  CHECK_THAT(message("a.obj", "v 0 0 0\nf 1 1\n"), Contains("2 corners; expected three or more"));
  CHECK_THAT(message("a.obj", "v 0 0 0\n"), Contains("a.obj: holds no face"));
}

TEST_CASE("what a broken file brings into a message stays on one line") {
  const Scratch scratch;
  const auto file = scratch.write("a.obj", std::string("v 0 0 a\x1b[31m\t\n"));
  const std::string message = error_of([&] { read_mesh(file); });
  CHECK(message.find_first_of("\n\r\x1b") == std::string::npos);
}
