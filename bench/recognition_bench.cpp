// SPDX-License-Identifier: Apache-2.0
// The software stage on the golden features of one scene of a kind, with 10, 100 and 1000 models.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "bench/ratios.hpp"
#include "bench/scenes.hpp"
#include "io/library.hpp"
#include "io/views.hpp"
#include "recognition/recognizer.hpp"

namespace trihedron::bench {
namespace {

/// The k-th of evenly spread factors between 0.6 and 1.6, another sequence per axis: multiples
/// of roots of primes, cut to their fractions.
double distortion(std::size_t k, int axis) {
  const double step = std::sqrt(axis == 0 ? 2.0 : axis == 1 ? 3.0 : 5.0);
  const double whole = static_cast<double>(k) * step;
  return 0.6 + whole - std::floor(whole);
}

/// The library grown to `count` models: the given ones first, then copies of them with every axis
/// stretched by a factor of its own, so that no two have the same edges.
std::vector<Model> grown(const std::vector<Model>& library, std::size_t count) {
  std::vector<Model> out = library;
  for (std::size_t k = out.size(); k < count; ++k) {
    Mesh mesh = library[k % library.size()].mesh;
    for (Eigen::Vector3d& x : mesh.vertices) {
      for (int axis = 0; axis < 3; ++axis) x[axis] *= distortion(k, axis);
    }
    out.push_back(build_model(static_cast<int>(k) + 1, fmt::format("distorted {}", k + 1), mesh));
  }
  return out;
}

/// A timed run; its counters say how the stages share the time, in %, and what was found.
void run_recognition(benchmark::State& state, const std::vector<View>& views,
                     const Recognizer& recognizer) {
  std::map<std::string, double> seconds;
  double sum = 0;
  std::size_t objects = 0;
  for (auto _ : state) {
    const RecognitionResult result = recognizer.recognize(views);
    objects = result.objects.size();
    for (const StageStatistics& stage : result.stages) {
      seconds[stage.stage] += stage.seconds;
      sum += stage.seconds;
    }
  }
  for (const auto& [stage, spent] : seconds) state.counters[stage + "_%"] = 100 * spent / sum;
  state.counters["objects"] = static_cast<double>(objects);
}

std::string name_of(const std::string& kind, std::size_t models) {
  return fmt::format("{} {} models", kind, models);
}

}  // namespace
}  // namespace trihedron::bench

int main(int argc, char** argv) {
  using namespace trihedron::bench;
  const std::vector<trihedron::Model> library = trihedron::read_library(models_folder());
  const std::map<std::size_t, std::vector<trihedron::Model>> libraries = {
      {10, library}, {100, grown(library, 100)}, {1000, grown(library, 1000)}};
  std::map<std::size_t, trihedron::Recognizer> recognizers;  // the libraries are indexed once
  for (const auto& [count, models] : libraries) recognizers.try_emplace(count, models);
  std::map<std::string, std::vector<trihedron::View>> scenes;
  for (const char* kind : {"cad-isolated", "studio-two", "lab-stacked", "lab-hd"}) {
    scenes[kind] = make_views(scene_of_kind(kind), trihedron::golden_front_end());
  }
  std::vector<Ratio> ratios;
  for (const auto& [kind, views] : scenes) {
    for (const auto& [count, recognizer] : recognizers) {
      benchmark::RegisterBenchmark(name_of(kind, count).c_str(), [&views = views,
                                                                  &recognizer = recognizer](
                                                                     benchmark::State& state) {
        run_recognition(state, views, recognizer);
      })->Unit(benchmark::kMillisecond);
      if (count == 10) continue;
      ratios.push_back({fmt::format("{} / 10 models, {}", count, kind), name_of(kind, count),
                        name_of(kind, 10)});
    }
  }
  return run_and_compare(argc, argv, ratios, 3);
}
