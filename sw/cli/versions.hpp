// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace trihedron::cli {

/// "trihedron 0.1.0", then a line for the compiler and one for each library it was built with.
std::string versions();

}  // namespace trihedron::cli
