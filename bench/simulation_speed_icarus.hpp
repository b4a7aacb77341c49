// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/stimulus.hpp"

namespace trihedron::bench {

/// Clocks per second of processor time that Icarus Verilog simulates of the RTL, all views fed with
/// `image`, every beat and record compared with the golden model's. Throws Error when Icarus is
/// missing or something differs.
double icarus_clocks_per_second(const sim::GreyImage& image);

}  // namespace trihedron::bench
