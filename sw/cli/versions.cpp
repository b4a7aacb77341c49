// SPDX-License-Identifier: Apache-2.0
#include "cli/versions.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>

#ifdef TRIHEDRON_WITH_SIM
#include "sim/versions.hpp"
#endif

namespace trihedron::cli {

std::string versions() {
  std::string out = fmt::format("trihedron {}\n", TRIHEDRON_VERSION);
#ifdef TRIHEDRON_WITH_SIM
  for (const auto& [name, version] : sim::versions()) out += fmt::format("{} {}\n", name, version);
#else
  out += "no simulation in this build\n";
#endif
  out += fmt::format("OpenCV {}\n", CV_VERSION);
  out += fmt::format("Eigen {}.{}.{}\nJSON {}.{}.{}\n", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                     EIGEN_MINOR_VERSION, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                     NLOHMANN_JSON_VERSION_PATCH);
  return out + fmt::format("compiler {}", __VERSION__);
}

}  // namespace trihedron::cli
