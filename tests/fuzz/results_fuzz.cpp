// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of results: a BOP CSV, a stored shard, the two JSON files beside the models
// of a library.
#include <filesystem>

#include "cli/shards.hpp"
#include "fuzz/harness.hpp"
#include "io/bop_results.hpp"
#include "io/library.hpp"
#include "scratch.hpp"

namespace {

using namespace trihedron;

constexpr const char* kCube =
    "OFF\n8 6 0\n0 0 0\n20 0 0\n20 20 0\n0 20 0\n0 0 20\n20 0 20\n20 20 20\n0 20 20\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

void read_shards(const Scratch& scratch, const std::string& bytes) {
  scratch.write("shards/shard-000001-of-000001.jsonl", bytes);
  const std::filesystem::path here = std::filesystem::current_path();
  const std::string folder = (scratch / "shards").string();
  fuzz::take_or_refuse([&] { cli::merging_command_line(folder); });
  std::filesystem::current_path(here);
  constexpr std::size_t kItems = 2;
  fuzz::take_or_refuse([&] { cli::run_sharded(kItems, 1, "items", {"", folder, true}, {}); });
}

void read_library_with(const Scratch& scratch, const std::string& name, const std::string& bytes) {
  const std::filesystem::path file = scratch.write("models/" + name, bytes);
  scratch.write("models/obj_000001.off", kCube);
  fuzz::take_or_refuse([&] { read_library(scratch / "models"); });
  std::filesystem::remove(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Scratch scratch;
  const std::string bytes = fuzz::rest_of(data, size);
  switch (fuzz::kind_of(data, size, 4)) {
    case 0:
      fuzz::take_or_refuse([&] { read_results(scratch.write("results.csv", bytes)); });
      break;
    case 1:
      read_shards(scratch, bytes);
      break;
    case 2:
      read_library_with(scratch, "models_info.json", bytes);
      break;
    default:
      read_library_with(scratch, "models_names.json", bytes);
  }
  return 0;
}
