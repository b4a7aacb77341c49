// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/device.hpp"

#include <cstdint>

namespace trihedron::sim {

/// Leaves the device in the middle of everything: `clocks` clocks of noise frames of changing size
/// on all views, back-pressure on both outputs and random values in every register, all from
/// `seed`. Ends with no input valid; the next thing is a reset, which must leave no trace of it.
void play_prelude(Device& device, std::uint64_t seed, int clocks);

}  // namespace trihedron::sim
