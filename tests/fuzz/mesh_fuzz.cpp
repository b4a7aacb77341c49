// SPDX-License-Identifier: Apache-2.0
// Any bytes as a mesh in each of the formats; one that is read becomes a model, or none.
#include "fuzz/harness.hpp"
#include "io/mesh.hpp"
#include "recognition/model.hpp"
#include "scratch.hpp"

namespace {

constexpr const char* kNames[] = {"mesh.ply", "mesh.off", "mesh.stl", "mesh.obj"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trihedron;
  static const Scratch scratch;
  const auto file = scratch.write(kNames[fuzz::kind_of(data, size, 4)], fuzz::rest_of(data, size));
  fuzz::take_or_refuse([&] { build_model(1, file.string(), read_mesh(file)); });
  return 0;
}
