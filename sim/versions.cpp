// SPDX-License-Identifier: Apache-2.0
#include "sim/versions.hpp"

#include <verilated.h>

#include <systemc>

namespace trihedron::sim {

std::vector<std::pair<std::string, std::string>> versions() {
  // "Verilator 5.006 2023-01-22": the product's name comes first.
  const std::string verilator = Verilated::productVersion();
  return {{Verilated::productName(), verilator},
          {"SystemC", std::to_string(SC_VERSION_MAJOR) + "." + std::to_string(SC_VERSION_MINOR) +
                          "." + std::to_string(SC_VERSION_PATCH)}};
}

}  // namespace trihedron::sim
