// SPDX-License-Identifier: Apache-2.0
#include "bench/scenes.hpp"

namespace trihedron::bench {

Scene scene_of_kind(const std::string& kind) {
  const std::filesystem::path folder = std::filesystem::path(TRIHEDRON_TESTVECTORS) / "scenes";
  return read_scene(find_scenes(folder / kind).front());
}

}  // namespace trihedron::bench
