// SPDX-License-Identifier: Apache-2.0
#include "recognition/model.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "golden/error.hpp"
#include "io/mesh.hpp"
#include "recognition/shapes.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using Eigen::Vector3d;

namespace {

constexpr double kRounding = 1e-9;  // relative, doubles

/// Signed volume of the model's own triangles, mm^3.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  return sum / 6;
}

/// Vertices - edges + surfaces, each hole of a surface counted as one cut.
int euler_characteristic(const Model& model) {
  int holes = 0;
  for (const Surface& s : model.surfaces) holes += static_cast<int>(s.loops.size()) - 1;
  return static_cast<int>(model.mesh.vertices.size()) - static_cast<int>(model.edges.size()) +
         static_cast<int>(model.surfaces.size()) - holes;
}

std::string message(const Mesh& mesh) {
  try {
    build_model(1, "part.ply", mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a block becomes six surfaces, twelve convex edges and eight corners") {
  const Model model = build_model(7, "block", shapes::block(40, 50, 60));
  CHECK(model.id == 7);
  CHECK(model.surfaces.size() == 6);
  CHECK(model.edges.size() == 12);
  CHECK(model.mesh.vertices.size() == 8);
  CHECK(model.diameter == Approx(std::sqrt(40 * 40 + 50 * 50 + 60 * 60)));
  for (const ModelEdge& e : model.edges) CHECK(e.convex);
  for (const auto& at_vertex : model.vertex_edges) CHECK(at_vertex.size() == 3);
  for (const Surface& s : model.surfaces) {
    CHECK(s.loops.size() == 1);
    CHECK(s.loops[0].size() == 4);
    CHECK(s.normal.dot(s.centroid - Vector3d(20, 25, 30)) > 0);
  }
}

TEST_CASE("finer triangles of the same solid give the same model") {
  const Mesh coarse = shapes::frame(80, 30, 20);
  const Model a = build_model(1, "a", coarse);
  const Model b = build_model(1, "b", shapes::subdivided(shapes::subdivided(coarse)));
  CHECK(b.mesh.vertices.size() == 16);
  CHECK(b.surfaces.size() == 10);
  CHECK(b.edges.size() == 24);
  CHECK(b.mesh.triangles.size() == a.mesh.triangles.size());
  CHECK(volume(b.mesh) == Approx(volume(a.mesh)).epsilon(kRounding));
  CHECK(b.symmetries.size() == a.symmetries.size());
}

TEST_CASE("a plate with a hole has surfaces with an outer and an inner boundary") {
  const Model model = build_model(1, "frame", shapes::frame(80, 30, 20));
  int with_hole = 0, concave = 0;
  for (const Surface& s : model.surfaces) {
    if (s.loops.size() != 2) continue;
    ++with_hole;
    CHECK(s.area == Approx(80 * 80 - 30 * 30));
    CHECK(s.perimeter == Approx(4 * 80 + 4 * 30));
    CHECK(s.centroid.head<2>().norm() < kRounding);
    double triangles = 0;
    for (int t : s.triangles) {
      const auto& v = model.mesh.triangles[t];
      const auto& x = model.mesh.vertices;
      const Vector3d cross = (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]);
      CHECK(cross.dot(s.normal) > 0);
      triangles += cross.norm() / 2;
    }
    CHECK(triangles == Approx(s.area));
  }
  for (const ModelEdge& e : model.edges) concave += e.convex ? 0 : 1;
  CHECK(with_hole == 2);
  CHECK(concave == 4);                      // the corners of the hole; its rims bulge outwards
  CHECK(euler_characteristic(model) == 0);  // one handle
  CHECK(volume(model.mesh) == Approx((80 * 80 - 30 * 30) * 20));
}

TEST_CASE("an inner corner is a concave edge") {
  const Model model = build_model(
      1, "l", shapes::prism({{20, 20}, {20, 60}, {0, 60}, {0, 0}, {60, 0}, {60, 20}}, 30));
  int concave = 0;
  for (const ModelEdge& e : model.edges)
    if (!e.convex) {
      ++concave;
      CHECK(e.length == Approx(30));
    }
  CHECK(concave == 1);
}

TEST_CASE("the ten bundled models are sound polyhedra") {
  constexpr int kSurfaces[] = {7, 5, 10, 16, 8, 12, 6, 8, 6, 10};
  for (int id = 1; id <= 10; ++id) {
    char file[32];
    std::snprintf(file, sizeof file, "/obj_%06d.ply", id);
    const Mesh mesh = read_mesh(std::string(TRIHEDRON_TESTVECTORS "/models10") + file);
    const Model model = build_model(id, file, mesh);
    INFO(file);
    CHECK(static_cast<int>(model.surfaces.size()) == kSurfaces[id - 1]);
    CHECK(euler_characteristic(model) == 2);
    CHECK(volume(model.mesh) == Approx(volume(mesh)).epsilon(1e-6));  // files hold 6 digits
    for (const Surface& s : model.surfaces)
      for (const auto& loop : s.loops)
        for (int v : loop) CHECK(std::abs(s.normal.dot(model.mesh.vertices[v]) - s.offset) < 1e-3);
  }
}

TEST_CASE("a mesh turned inside out is turned back") {
  Mesh mesh = shapes::block(40, 50, 60);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  CHECK(volume(build_model(1, "m", mesh).mesh) == Approx(40 * 50 * 60));
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);  // and one triangle the other way
  CHECK(volume(build_model(1, "m", mesh).mesh) == Approx(40 * 50 * 60));
}

TEST_CASE("separate triangles with equal corners are welded, as STL needs") {
  const Mesh block = shapes::block(40, 50, 60);
  Mesh soup;
  for (const auto& t : block.triangles) {
    const int base = static_cast<int>(soup.vertices.size());
    for (int v : t) soup.vertices.push_back(block.vertices[v]);
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  CHECK(build_model(1, "soup", soup).mesh.vertices.size() == 8);
}

TEST_CASE("a mesh that is no closed polyhedron is refused with the edge named") {
  Mesh open = shapes::block(40, 50, 60);
  open.triangles.pop_back();
  CHECK_THAT(message(open), Contains("part.ply: not closed: the edge from (") &&
                                Contains("belongs to 1 triangle;"));
  Mesh fin = shapes::block(40, 50, 60);
  fin.vertices.emplace_back(20, -30, 70);
  fin.triangles.push_back({4, 5, 8});
  fin.triangles.push_back({5, 4, 8});
  CHECK_THAT(message(fin), Contains("not manifold: the edge from (0, 0, 60) to (40, 0, 60)") &&
                               Contains("belongs to 4 triangles"));
}

TEST_CASE("empty, broken, flat, curved and wrongly scaled meshes are refused with a reason") {
  CHECK_THAT(message({}), Contains("the mesh is empty"));
  Mesh broken = shapes::block(40, 50, 60);
  broken.triangles[2][1] = 99;
  CHECK_THAT(message(broken), Contains("triangle 2 uses vertex 99; expected 0 to 7"));
  broken = shapes::block(40, 50, 60);
  broken.vertices[3].x() = std::nan("");
  CHECK_THAT(message(broken), Contains("not a finite number"));
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {50, 0, 0}, {0, 50, 0}};
  flat.triangles = {{0, 1, 2}, {2, 1, 0}};
  CHECK_THAT(message(flat), Contains("encloses no volume"));
  CHECK_THAT(message(shapes::regular_prism(100, 30, 50)), Contains("curved (102 planar faces"));
  CHECK_THAT(message(shapes::regular_prism(2000, 30, 50)), Contains("lies outside the method"));
  CHECK_THAT(message(shapes::block(40e3, 50e3, 60e3)), Contains("is its unit the mm?"));
  CHECK_THAT(message(shapes::block(0.04, 0.05, 0.06)), Contains("is its unit the mm?"));
  CHECK(build_model(1, "m", shapes::regular_prism(20, 30, 50)).surfaces.size() == 22);
}
