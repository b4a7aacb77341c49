// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace trihedron::sim {

/// Names and versions of the tools that made this simulation.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace trihedron::sim
