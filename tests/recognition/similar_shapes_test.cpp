// SPDX-License-Identifier: Apache-2.0
#include "recognition/similar_shapes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "recognition/rigs.hpp"

using namespace trihedron;
using Eigen::Vector3d;

namespace {

const Transform kPose = rigs::pose({0.1, 0.05, 0.6}, {-5, 4, 32});

/// Three views of an object, as similar_shapes() wants them.
struct Seen {
  explicit Seen(const Model& truth, const Transform& pose)
      : views(rigs::views_of({{&truth, pose}})) {
    fields.reserve(views.size());
    for (const View& view : views) {
      fields.emplace_back(view.features);
      field_views.push_back({&view.camera, &fields.back()});
      maps.push_back(spread_map(fields.back()));
    }
  }
  SimilarShapes similar_to(const PlacedModel& placed) const {
    return similar_shapes(field_views, maps, placed, collect_evidence(field_views, {placed}, 0));
  }

  std::vector<View> views;
  std::vector<ContourField> fields;
  std::vector<FieldView> field_views;
  std::vector<SpreadMap> maps;
};

/// Where the placed shape's vertices are, against the truth's: largest distance to the nearest, mm.
double vertex_error(const SimilarShape& shape, const Model& truth) {
  double largest = 0;
  for (const Vector3d& v : shape.model.mesh.vertices) {
    double nearest = 1e9;
    for (const Vector3d& w : truth.mesh.vertices) {
      nearest = std::min(nearest, (shape.world_from_model * v - kPose * w).norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

}  // namespace

TEST_CASE("reshaped to its own vertices, a model stays as it is; to others, its planes follow") {
  const Model model = rigs::l_bracket();
  const Model same = reshaped(model, model.mesh.vertices);
  std::vector<Vector3d> longer = model.mesh.vertices;
  for (Vector3d& v : longer) v.x() *= 1.1;
  const Model changed = reshaped(model, longer);
  for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
    CHECK((same.surfaces[s].normal - model.surfaces[s].normal).norm() < 1e-12);
    CHECK(same.surfaces[s].area == Approx(model.surfaces[s].area));
    CHECK((same.surfaces[s].centroid - model.surfaces[s].centroid).norm() < 1e-9);
    for (const int v : changed.surfaces[s].loops[0]) {
      CHECK(std::abs(changed.surfaces[s].normal.dot(longer[v]) - changed.surfaces[s].offset) <
            1e-9);
    }
  }
}

TEST_CASE("where a longer object stands, the model made longer is what its edges ask for") {
  const Model model = rigs::block(60, 50, 40), truth = rigs::block(66, 50, 40);
  const Seen seen(truth, kPose);
  // Its far end, 3 mm beyond the middle's, lies where the object's is; the near end is 6 mm short.
  const Transform at_end = kPose * rigs::pose({0, 0, 0}, {3, 0, 0});
  const SimilarShapes similar = seen.similar_to({&model, at_end});
  REQUIRE_FALSE(similar.shapes.empty());
  REQUIRE(similar.shapes.size() <= kSimilarTried);
  constexpr double kContourMm = 1.0;  // displaced contours are whole pixels of 0.5 mm
  CHECK(vertex_error(similar.shapes[0], truth) < kContourMm);
  CHECK(similar.log_choices > 0);
}

TEST_CASE("an object that is what its model says has nothing like it") {
  const Model truth = rigs::l_bracket();
  const SimilarShapes similar = Seen(truth, kPose).similar_to({&truth, kPose});
  CHECK(similar.shapes.empty());
}

TEST_CASE("a model is stretched both ways along each axis, with its middle or an end at rest") {
  const Model model = rigs::block(60, 50, 40);
  const SimilarShapes stretched = stretched_shapes({&model, kPose});
  REQUIRE(stretched.shapes.size() == 6 * kStretchPlaces);
  CHECK(stretched.log_choices == Approx(std::log(18)));
  for (const SimilarShape& shape : stretched.shapes) {
    Vector3d low = shape.model.mesh.vertices[0], high = low;
    for (const Vector3d& v : shape.model.mesh.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    const Vector3d size(60, 50, 40), ratio = (high - low).cwiseQuotient(size);
    const double moved_low = (low + size / 2).norm(), moved_high = (high - size / 2).norm();
    CHECK((std::min(moved_low, moved_high) < 1e-9 || moved_low == Approx(moved_high)));
    CHECK(std::abs(ratio.sum() - 3) == Approx(kSimilarStretch));
  }
}
