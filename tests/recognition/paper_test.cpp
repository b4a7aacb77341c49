// SPDX-License-Identifier: Apache-2.0
#include "recognition/paper.hpp"

#include <catch2/catch.hpp>

#include "golden/error.hpp"
#include "recognition/evaluation.hpp"
#include "recognition/paper_scenes.hpp"

using namespace trihedron;
using namespace trihedron::paper_scenes;

namespace {

std::vector<View> views_of(const std::vector<Camera>& cameras,
                           const std::vector<PlacedModel>& objects) {
  std::vector<View> views;
  for (const Camera& camera : cameras)
    views.push_back({camera, rigs::features_of(camera, objects)});
  return views;
}

RecognitionOptions paper() {
  RecognitionOptions options;
  options.method = Method::kPaper;
  return options;
}

/// One edge and a centroid fix the paper's position; each is good to about a quarter pixel.
constexpr double kVertexMm = 0.5;

}  // namespace

TEST_CASE("method paper finds a box and an L where they stand") {
  const std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket()};
  const std::vector<TrueObject> truth = {{1, rigs::pose({0, 0, 0.5}, {-45, 10, 20})},
                                         {2, rigs::pose({0, 0, 3.6}, {45, -5, 20})}};
  const auto views = views_of(exact_views(), {{&library[0], truth[0].world_from_model},
                                              {&library[1], truth[1].world_from_model}});
  const RecognitionResult result = recognize(views, library, paper());
  REQUIRE(result.objects.size() == 2);
  CHECK(result.objects[0].score >= result.objects[1].score);
  const SceneScore score = score_scene(result, truth, library);
  CHECK(score.wrong == 0);
  for (const ObjectScore& object : score.objects) {
    CHECK(object.right);
    CHECK(object.vertex_mm < kVertexMm);
  }
  CHECK(score.surfaces_right >= 5);
  REQUIRE(result.stages.size() == 4);
  CHECK(result.stages[0].stage == "regions");
  CHECK(result.stages[3].count == 2);
}

TEST_CASE("the trace holds the paper's tables") {
  const std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket()};
  const Transform pose = standing(25, 40);
  PaperTrace trace;
  const RecognitionResult result =
      recognize_paper(views_of(exact_views(), {{&library[0], pose}}), library, paper(), &trace);
  CHECK(trace.regions == std::array<int, 3>{1, 2, 2});
  CHECK(trace.duplicates == 1);
  REQUIRE(trace.surfaces.size() == 4);
  CHECK(paper_name(trace.surfaces[0]) == "s1");
  CHECK(paper_name(trace.surfaces[1])[0] == 'l');
  CHECK(paper_name(trace.surfaces[3])[0] == 'f');
  REQUIRE(trace.hypotheses.size() == 4);
  CHECK(trace.hypotheses[0][0].model == 0);
  REQUIRE_FALSE(trace.priority_list.empty());
  CHECK(trace.priority_list[0].model == 0);
  CHECK(trace.priority_list[0].matches.size() == 4);
  CHECK(trace.priority_list[0].position.error_mm < kVertexMm);
  CHECK(result.objects.size() == 1);
}

TEST_CASE("the order of the views does not matter") {
  const std::vector<Model> library = {rigs::block(60, 50, 40)};
  std::vector<View> views = views_of(exact_views(), {{&library[0], standing(25, 40)}});
  const RecognitionResult before = recognize(views, library, paper());
  std::swap(views[0], views[2]);
  const RecognitionResult after = recognize(views, library, paper());
  REQUIRE(before.objects.size() == 1);
  REQUIRE(after.objects.size() == 1);
  CHECK(before.objects[0].world_from_model.t == after.objects[0].world_from_model.t);
  CHECK(after.surfaces[0].view == 2);
}

TEST_CASE("without the surfaces of side and front there is no answer") {
  const std::vector<Model> library = {rigs::block(60, 50, 40)};
  std::vector<View> views = views_of(exact_views(), {{&library[0], standing(25, 40)}});
  for (const std::size_t v : {1, 2}) views[v].features = rigs::features_of(views[v].camera, {});
  const RecognitionResult result = recognize(views, library, paper());
  CHECK(result.objects.empty());
  CHECK(result.surfaces.empty());
}

TEST_CASE("an object that is not in the library is not taken for one that is") {
  const Model unknown = rigs::l_bracket();
  const std::vector<Model> library = {rigs::block(90, 70, 55)};
  const auto views = views_of(exact_views(), {{&unknown, standing(25, 40)}});
  CHECK(recognize(views, library, paper()).objects.empty());
}

TEST_CASE("method paper needs a top, a side and a front view") {
  const std::vector<Model> library = {rigs::block(60, 50, 40)};
  std::vector<View> views = views_of(exact_views(), {{&library[0], standing(25, 40)}});
  views.pop_back();
  REQUIRE_THROWS_AS(recognize(views, library, paper()), Error);
  REQUIRE_THROWS_WITH(recognize(views, library, paper()), Catch::Contains("0 front"));
}
