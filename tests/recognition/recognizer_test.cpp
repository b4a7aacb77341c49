// SPDX-License-Identifier: Apache-2.0
#include "recognition/recognizer.hpp"

#include <catch2/catch.hpp>
#include <thread>

#include "golden/error.hpp"
#include "recognition/rigs.hpp"

using namespace trihedron;

namespace {

/// Bit for bit, but for the times.
bool equal(const RecognitionResult& a, const RecognitionResult& b) {
  const auto same_object = [](const RecognizedObject& p, const RecognizedObject& q) {
    return p.model_id == q.model_id && p.world_from_model.R == q.world_from_model.R &&
           p.world_from_model.t == q.world_from_model.t && p.covariance == q.covariance &&
           p.score == q.score && p.runner_up_model_id == q.runner_up_model_id;
  };
  const auto same_rejection = [](const Rejection& p, const Rejection& q) {
    return p.model_id == q.model_id && p.score == q.score && p.reason == q.reason;
  };
  return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    same_object) &&
         std::equal(a.rejections.begin(), a.rejections.end(), b.rejections.begin(),
                    b.rejections.end(), same_rejection);
}

}  // namespace

TEST_CASE("a recognizer that threads share answers as a fresh one does, bit for bit") {
  const std::vector<Model> library = {rigs::block(60, 50, 40), rigs::l_bracket()};
  std::vector<std::vector<View>> scenes;
  std::vector<RecognitionResult> expected;
  for (int k = 0; k < 4; ++k) {
    const Transform pose = rigs::pose({0.1, 0.05, 0.6 + 0.3 * k}, {-5, 4.0 * k, 32});
    scenes.push_back(rigs::views_of({{&library[static_cast<std::size_t>(k) % 2], pose}}));
    expected.push_back(recognize(scenes.back(), library));
    REQUIRE(expected.back().objects.size() == 1);
  }
  const Recognizer recognizer(library);
  for (const std::size_t count : {1U, 2U, 4U}) {
    std::vector<RecognitionResult> results(scenes.size());
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < count; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < scenes.size(); i += count) {
          results[i] = recognizer.recognize(scenes[i]);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      INFO(count << " threads, scene " << i);
      CHECK(equal(results[i], expected[i]));
    }
  }
}

TEST_CASE("a recognizer of no models is refused") {
  const std::vector<Model> none;
  CHECK_THROWS_AS(Recognizer(none), Error);
}
