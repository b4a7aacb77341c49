// SPDX-License-Identifier: Apache-2.0
// Meshes that nobody here made: those of Debian's libcgal-demo, where it is installed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>

#include "io/mesh.hpp"
#include "io/polygons.hpp"
#include "scratch.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;

namespace {

constexpr const char* kArchive = "/usr/share/doc/libcgal-demo/data.tar.gz";

/// The archive's meshes, 100 mm wide: their own sizes have no unit.
class ForeignMeshes {
 public:
  bool available() {
    if (!std::filesystem::exists(kArchive)) {
      WARN("libcgal-demo is not installed: its meshes are not tried");
      return false;
    }
    const std::string command =
        std::string("tar xzf ") + kArchive + " -C " + scratch_.path().string() + " data/meshes";
    return std::system(command.c_str()) == 0;
  }
  Model model(const std::string& name) const {
    Mesh mesh = read_mesh(scratch_ / ("data/meshes/" + name));
    double size = 0;
    for (const auto& x : mesh.vertices) size = std::max(size, (x - mesh.vertices[0]).norm());
    for (auto& x : mesh.vertices) x *= 100 / size;
    return build_model(1, name, mesh);
  }

 private:
  Scratch scratch_;
};

int euler_characteristic(const Model& m) {
  int holes = 0;
  for (const Surface& s : m.surfaces) holes += static_cast<int>(s.loops.size()) - 1;
  return static_cast<int>(m.mesh.vertices.size() + m.surfaces.size()) -
         static_cast<int>(m.edges.size()) - holes;
}

}  // namespace

TEST_CASE("polyhedra of other people become the models that they are") {
  ForeignMeshes meshes;
  if (!meshes.available()) return;
  const struct {
    const char* name;
    std::size_t surfaces, edges, symmetries;
    int euler;
  } cases[] = {
      {"cube.off", 6, 12, 23, 2},         {"cube-meshed.off", 6, 12, 23, 2},
      {"cube_poly.off", 6, 12, 23, 2},    {"cube-shuffled.off", 6, 12, 23, 2},
      {"beam.off", 6, 12, 7, 2},          {"cross.off", 14, 36, 7, 2},
      {"cross_quad.off", 14, 36, 7, 2},   {"octahedron.off", 8, 12, 23, 2},
      {"icosahedron.off", 20, 30, 59, 2}, {"star.off", 24, 36, 23, 2},
      {"pyramid.off", 5, 8, 3, 2},        {"P.off", 15, 39, 0, 0},  // the letter P: one handle
      {"3torus.off", 23, 46, 1, -4},                                // three handles
      {"torus_quad.off", 25, 50, 9, 0},   {"tripod.off", 39, 60, 0, 2},
      {"u.off", 76, 157, 0, 2},
  };
  for (const auto& c : cases) {
    const Model model = meshes.model(c.name);
    INFO(c.name);
    CHECK(model.surfaces.size() == c.surfaces);
    CHECK(model.edges.size() == c.edges);
    CHECK(model.symmetries.size() == c.symmetries);
    CHECK(euler_characteristic(model) == c.euler);
  }
}

TEST_CASE("open and curved meshes of other people are refused with the reason") {
  ForeignMeshes meshes;
  if (!meshes.available()) return;
  for (const char* name : {"open_cube.off", "quad.off", "hedra_open.off", "cylinder.off"})
    CHECK_THAT(error_of([&] { meshes.model(name); }),
               Contains(std::string(name) + ": not closed: the edge from ("));
  for (const char* name : {"sphere.off", "elephant.off", "joint.off", "knot1.off", "hand.off"})
    CHECK_THAT(error_of([&] { meshes.model(name); }), Contains("curved ("));
}

TEST_CASE("an OFF file's comments, blank lines and colours do not disturb") {
  const Scratch scratch;
  const auto file = scratch.write("a.off",
                                  "# made by hand\n\nCOFF 4 4 6 # counts\n\n0 0 0 255 0 0\n"
                                  "  40 0 0 255 0 0\n# a comment\n0 50 0 1 1 1\r\n0 0 60 1 1 1\n\n"
                                  "3 0 2 1 9 9 9\n3 0 1 3\n\n3 1 2 3 # slanted\n3 2 0 3\n");
  const Polygons polygons = read_off(file);
  CHECK(polygons.vertices.size() == 4);
  CHECK(polygons.faces.size() == 4);
  CHECK(build_model(1, "a", triangulate("a", polygons)).surfaces.size() == 4);
}

TEST_CASE("a broken OFF file is named with its line") {
  const Scratch scratch;
  const auto message = [&](const std::string& text) {
    const auto file = scratch.write("a.off", text);
    return error_of([&] { read_off(file); });
  };
  CHECK_THAT(message("FOO\n"), Contains("a.off: line 1: no OFF file"));
  CHECK_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 0\n"), Contains("the file ends here; expected x y z"));
  CHECK_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 x\n"), Contains("line 4: \"x\" is no number"));
  CHECK_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
             Contains("line 6: 3 is no vertex; expected 0 to 2"));
  CHECK_THAT(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n"), Contains("line 6: 4 corners"));
  CHECK_THAT(message("OFF\n-3 1 0\n"), Contains("line 2: not a count"));
}

TEST_CASE("PLY reads the same from ASCII and from binary of both byte orders") {
  const Scratch scratch;
  const float corners[4][3] = {{0, 0, 0}, {40, 0, 0}, {0, 50, 0}, {0, 0, 60}};
  const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (bool big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                        "_endian 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty "
                        "uchar red\nproperty float y\nproperty float z\nelement face 4\nproperty "
                        "list uchar int vertex_index\nend_header\n";
    const auto add = [&](const auto& value) {
      std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
      if (big) std::reverse(raw.begin(), raw.end());
      bytes += raw;
    };
    for (const auto& x : corners) {
      add(x[0]);
      bytes += '\xff';
      add(x[1]);
      add(x[2]);
    }
    for (const auto& f : faces) {
      bytes += '\3';
      for (std::int32_t v : f) add(v);
    }
    const Polygons polygons = read_ply(scratch.write("a.ply", bytes));
    REQUIRE(polygons.vertices.size() == 4);
    CHECK(polygons.vertices[3].z() == 60);
    CHECK(polygons.faces[3] == std::vector<int>{2, 0, 3});
    CHECK_THAT(
        error_of([&] { read_ply(scratch.write("b.ply", bytes.substr(0, bytes.size() - 1))); }),
        Contains("b.ply: the file ends too early"));
  }
}

TEST_CASE("a broken PLY file is named with what is wrong") {
  const Scratch scratch;
  const auto message = [&](const std::string& text) {
    const auto file = scratch.write("a.ply", text);
    return error_of([&] { read_mesh(file); });
  };
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  CHECK_THAT(message("ply\nformat ascii 1.0\n"), Contains("a.ply: the header has no end_header"));
  CHECK_THAT(message("plx\n"), Contains("does not begin with"));
  CHECK_THAT(message("ply\nformat text 1.0\nend_header\n"), Contains("unknown format \"text\""));
  CHECK_THAT(message(header + "0 0 0 1 0 0 0 1"), Contains("the file ends too early"));
  CHECK_THAT(message(header + "0 0 0 1 0 0 0 a 0 3 0 1 2"), Contains("a word is no number"));
  CHECK_THAT(message(header + "0 0 0 1 0 0 0 1 0 3 0 1 3"), Contains("a face uses vertex 3"));
  CHECK_THAT(message(header + "0 0 0 1 0 0 0 1 0 3 0 1 -2"), Contains("-2 is no vertex"));
}

TEST_CASE("a concave polygon is cut along its inside") {
  Polygons polygons;
  polygons.vertices = {{0, 0, 0}, {40, 0, 0}, {40, 40, 0}, {20, 10, 0}, {0, 40, 0}};
  polygons.faces = {{0, 1, 2, 3, 4}};
  const Mesh mesh = triangulate("a", polygons);
  REQUIRE(mesh.triangles.size() == 3);
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Eigen::Vector3d b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const double z = a.x() * b.y() - a.y() * b.x();
    CHECK(z > 0);
    area += z / 2;
  }
  CHECK(area == Approx(40 * 40 - 20 * 30));
}
