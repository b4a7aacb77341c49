// SPDX-License-Identifier: Apache-2.0
#include "recognition/evidence.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

/// Three views whose segments are the edges of a model in a pose that turn to them.
std::vector<ViewLines> lines_of(const Model& model, const Transform& pose) {
  std::vector<ViewLines> views;
  for (const Camera& camera : rigs::three_views()) {
    ViewLines v{IdealView(camera), camera.width_px, camera.height_px, {}, {}, {}, {}};
    for (const VisibleEdge& edge : visible_edges(camera, {{&model, pose}})) {
      Segment s;
      s.p0 = edge.x0;
      s.p1 = edge.x1;
      s.length = edge.length_px;
      s.direction = (s.p1 - s.p0) / s.length;
      s.normal = {-s.direction.y(), s.direction.x()};
      v.segments.push_back(s);
      v.planes.push_back(v.ideal.plane(s.p0, s.p1));
    }
    views.push_back(v);
  }
  return views;
}

}  // namespace

TEST_CASE("what is judged kindly never scores less than what is judged exactly") {
  const Model model = rigs::l_bracket();
  const LibraryIndex index({model});
  const Transform truth = rigs::pose({0.1, 0.05, 0.6}, {-5, 4, 32});
  const std::vector<ViewLines> views = lines_of(model, truth);
  const Evidence evidence(views);
  std::mt19937 random(21);
  std::normal_distribution<double> turn(0, 0.1), shift(0, 4);
  constexpr float kFloat = 1e-3F;  // of sums of a hundred single precision numbers
  constexpr float kStopped = -8;   // the test ended before the sum
  int summed = 0;
  for (int k = 0; k < 2000; ++k) {
    const double spread = 0.001 * k;
    Transform pose = truth;
    pose.R = Eigen::AngleAxisd(spread * turn(random),
                               Vector3d(turn(random), turn(random), 0.1).normalized()) *
             pose.R;
    pose.t += spread * Vector3d(shift(random), shift(random), shift(random));
    for (const bool two : {false, true}) {
      const float kind = evidence.score_at_most(index.sketch(0), pose, two);
      if (kind < kStopped) continue;
      ++summed;
      INFO("pose " << k << ", two samples " << two);
      REQUIRE(kind >= evidence.score(index.sketch(0), pose, two ? 2 : 1) - kFloat);
    }
  }
  CHECK(summed > 2000);
  CHECK_FALSE(evidence.hopeless(index.sketch(0), truth));
  Transform elsewhere = truth;
  elsewhere.t += Vector3d(25, 25, 0);
  CHECK(evidence.hopeless(index.sketch(0), elsewhere));
}

TEST_CASE("evidence along a spoke grows to the edge's end and falls beyond") {
  const Model model = rigs::block(60, 45, 35);
  const Transform pose = rigs::pose({0, 0, 0.3}, {0, 0, 17.5});
  const std::vector<ViewLines> views = lines_of(model, pose);
  const Evidence evidence(views);
  const std::vector<double> everywhere(views.size(), 0.0);
  const double never = std::numeric_limits<double>::infinity();
  int asked = 0;
  for (const ModelEdge& edge : model.edges) {
    const Vector3d a = pose * model.mesh.vertices[static_cast<std::size_t>(edge.v0)];
    const Vector3d b = pose * model.mesh.vertices[static_cast<std::size_t>(edge.v1)];
    if (std::min(a.z(), b.z()) < 30) continue;  // of the top: all cameras see them
    const Vector3d d = (b - a).normalized();
    const auto length = static_cast<float>(edge.length);
    Spoke spoke;
    evidence.ask_along(a, d, everywhere, 2 * edge.length, spoke);
    INFO("edge of " << length << " mm");
    CHECK(spoke.evidence(0) == 0);
    CHECK(spoke.evidence(0.5F * length) > 0);
    CHECK(spoke.evidence(0.9F * length) > spoke.evidence(0.5F * length));
    // A sample of 10 px beyond the end may still be near the segment.
    CHECK(spoke.evidence(2 * length) < spoke.evidence(1.2F * length));
    CHECK(spoke.evidence(9 * length) == spoke.evidence(3 * length));
    evidence.ask_along(a, d, {never, never, never}, 2 * edge.length, spoke);
    CHECK(spoke.evidence(length) == 0);
    evidence.ask_along(a, d, std::vector<double>(views.size(), 1.2 * edge.length), 2 * edge.length,
                       spoke);
    CHECK(spoke.evidence(0.9F * length) == 0);
    CHECK(spoke.evidence(2 * length) < 0);
    ++asked;
  }
  CHECK(asked == 4);
}
