// SPDX-License-Identifier: Apache-2.0
#include "bench/ratios.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>

namespace trihedron::bench {
namespace {

/// Prints what Google Benchmark prints and keeps every repetition's CPU time, ns.
class Collector : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        times_[run.run_name.function_name].push_back(run.cpu_accumulated_time /
                                                     static_cast<double>(run.iterations) * 1e9);
      }
      if (run.repetitions == 1 || run.aggregate_name == "median") shown.push_back(run);
    }
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
  }

  /// Median CPU time, ns; 0 when the benchmark did not run.
  double median(const std::string& name) const {
    const auto at = times_.find(name);
    if (at == times_.end()) return 0;
    std::vector<double> sorted = at->second;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

}  // namespace

int run_and_compare(int argc, char** argv, const std::vector<Ratio>& ratios, int repetitions) {
  std::vector<char*> arguments(argv, argv + argc);
  std::string turns = "--benchmark_repetitions=" + std::to_string(repetitions);
  std::string interleaving = "--benchmark_enable_random_interleaving=true";
  std::string least_time = "--benchmark_min_time=0.05";
  for (std::string* option : {&least_time, &interleaving, &turns}) {
    arguments.insert(arguments.begin() + 1, option->data());  // before the user's, which win
  }
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);

  std::printf("\n%-58s %10s\n", "ratio of times", "ratio");
  for (const Ratio& ratio : ratios) {
    const double numerator = collector.median(ratio.numerator);
    const double denominator = collector.median(ratio.denominator);
    if (numerator <= 0 || denominator <= 0) continue;  // filtered out
    std::printf("%-58s %10.2f\n", ratio.what.c_str(), numerator / denominator);
  }
  return 0;
}

}  // namespace trihedron::bench
