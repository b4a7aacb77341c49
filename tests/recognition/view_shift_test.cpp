// SPDX-License-Identifier: Apache-2.0
#include "recognition/view_shift.hpp"

#include <catch2/catch.hpp>

#include "recognition/object_evidence.hpp"
#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector2d;

namespace {

const Transform kPose = rigs::pose({0.1, 0.05, 0.6}, {-5, 4, 32});

}  // namespace

TEST_CASE("a camera whose calibration is off is found to be off by as much") {
  const Model model = rigs::l_bracket();
  const Camera camera = rigs::three_views()[0];
  const ViewFeatures features = rigs::features_of(camera, {{&model, kPose}});
  const ContourField field(features);
  for (const Vector2d& off : {Vector2d(0, 0), Vector2d(1.5, -1), Vector2d(-2, 0.5)}) {
    Camera believed = camera;
    believed.K(0, 2) -= off.x();
    believed.K(1, 2) -= off.y();
    const FieldView view{&believed, &field};
    const auto points =
        edge_points(view, 0, visible_edges(believed, {{&model, kPose}}), kEvidenceStepPx, 4);
    constexpr double kPixelPx = 0.7;  // thinning to whole pixels moves contours by up to so much
    CHECK((view_shift(field, points) - off).norm() < kPixelPx);
  }
}

TEST_CASE("views that disagree by two pixels give an object's evidence all the same") {
  const Model model = rigs::l_bracket();
  std::vector<Camera> cameras = rigs::three_views();
  const std::vector<View> seen = rigs::views_of({{&model, kPose}});
  std::vector<ContourField> fields;
  fields.reserve(cameras.size());
  std::vector<FieldView> views;
  for (std::size_t v = 0; v < cameras.size(); ++v) {
    fields.emplace_back(seen[v].features);
    views.push_back({&cameras[v], &fields.back()});
  }
  const ObjectEvidence exact = collect_evidence(views, {{&model, kPose}}, 0);
  cameras[1].K(0, 2) += 1.4;
  cameras[1].K(1, 2) -= 1.4;
  const ObjectEvidence off = collect_evidence(views, {{&model, kPose}}, 0);
  CHECK(exact.found_px > 0);
  CHECK(off.found_px > 0.95 * exact.found_px);
}

TEST_CASE("where no contour is near, nothing is shifted") {
  const Model model = rigs::block(60, 50, 40);
  const Camera camera = rigs::three_views()[0];
  const ViewFeatures features = rigs::features_of(camera, {});
  const ContourField field(features);
  const FieldView view{&camera, &field};
  const auto points =
      edge_points(view, 0, visible_edges(camera, {{&model, kPose}}), kEvidenceStepPx, 4);
  REQUIRE_FALSE(points.empty());
  CHECK(view_shift(field, points) == Vector2d(0, 0));
}
