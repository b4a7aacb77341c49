// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/views.hpp"
#include "report/hardware_activity.hpp"

namespace trihedron::cli {

/// The simulated hardware as front end: up to three images side by side, one per view. Bit for
/// bit the same features as golden_front_end(). Throws Error when an image does not fit this
/// build of the hardware, or when the build has no simulation. Each call of the front end stores
/// in `activity`, unless null, what the simulation counted.
FrontEnd rtl_front_end(report::HardwareActivity* activity = nullptr);

/// "rtl", or "golden" in a build without simulation.
std::string default_front_end();

}  // namespace trihedron::cli
