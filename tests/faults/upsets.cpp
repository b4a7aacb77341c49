// SPDX-License-Identifier: Apache-2.0
// Flips one flip-flop at a time, at random, while frames run, and says what became of it.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "faults/experiment.hpp"
#include "sim/random.hpp"

namespace {

using namespace trihedron;
using faults::Consequence;

constexpr std::array<const char*, faults::kConsequences> kNames = {
    "masked", "one_frame", "two_frames", "more_frames", "late", "tags", "registers", "reset"};
constexpr int kUpsetsPerScene = 20;

struct Arguments {
  int upsets = 1000;
  std::uint64_t seed = 1;
  std::string json;
  // One upset to repeat.
  std::uint64_t scene = 0, clock = 0;
  std::string flip_flop;
};

nlohmann::json to_json(const faults::Upset& upset) {
  return {{"scene", upset.scene},
          {"clock", upset.clock},
          {"flip_flop", upset.flip_flop},
          {"name", upset.name},
          {"consequence", kNames[static_cast<std::size_t>(upset.consequence)]}};
}

int run(const Arguments& arguments) {
  std::array<int, faults::kConsequences> counts{};
  nlohmann::json all = nlohmann::json::array();
  std::size_t flip_flops = 0;
  sim::Random random(arguments.seed);
  for (int done = 0; done < arguments.upsets;) {
    const faults::Scene scene = faults::make_scene(random.next());
    const faults::Window window = faults::dry_run(scene);
    flip_flops = window.flip_flops.size();
    for (int i = 0; i < kUpsetsPerScene && done < arguments.upsets; ++i, ++done) {
      const auto clock = window.first + random.next() % (window.last - window.first + 1);
      const faults::Upset upset = faults::run_upset(
          scene, clock, window.flip_flops[random.next() % window.flip_flops.size()]);
      ++counts[static_cast<std::size_t>(upset.consequence)];
      all.push_back(to_json(upset));
    }
  }
  if (!arguments.json.empty()) std::ofstream(arguments.json) << all.dump(0) << "\n";
  std::printf("%d upsets of %zu flip-flops, seed %llu:", arguments.upsets, flip_flops,
              static_cast<unsigned long long>(arguments.seed));
  for (std::size_t i = 0; i < counts.size(); ++i) std::printf(" %s %d", kNames[i], counts[i]);
  std::printf("\n");
  return counts[static_cast<std::size_t>(Consequence::kLate)] == 0 &&
                 counts[static_cast<std::size_t>(Consequence::kReset)] == 0
             ? 0
             : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App program("Single upsets of flip-flops in the simulated hardware");
  program.add_option("--upsets", arguments.upsets, "How many")->capture_default_str();
  program.add_option("--seed", arguments.seed, "Of frames, clocks and flip-flops")
      ->capture_default_str();
  program.add_option("--json", arguments.json, "Write every upset")->type_name("FILE");
  program.add_option("--scene", arguments.scene, "Repeat one upset: its scene");
  program.add_option("--clock", arguments.clock, "Its clock");
  program.add_option("--flip-flop", arguments.flip_flop, "Its flip-flop's name");
  CLI11_PARSE(program, argc, argv);
  try {
    if (arguments.scene == 0) return run(arguments);
    const faults::Scene scene = faults::make_scene(arguments.scene);
    faults::dry_run(scene);
    const faults::Upset upset =
        faults::run_upset(scene, arguments.clock, faults::flip_flop_called(arguments.flip_flop));
    std::printf("%s\n%s", to_json(upset).dump().c_str(), upset.details.c_str());
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "upsets: " << error.what() << "\n";
    return 2;
  }
}
