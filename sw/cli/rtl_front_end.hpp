// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/views.hpp"

namespace trihedron::cli {

/// The simulated hardware as front end: up to three images side by side, one per view. Bit for
/// bit the same features as golden_front_end(). Throws Error when an image does not fit this
/// build of the hardware, or when the build has no simulation.
FrontEnd rtl_front_end();

/// "rtl", or "golden" in a build without simulation.
std::string default_front_end();

}  // namespace trihedron::cli
