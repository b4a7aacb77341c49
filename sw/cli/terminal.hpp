// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace trihedron::cli {

enum class Tone { kGood, kBad, kFaint, kHeading };

/// Whether colours may be printed there: a terminal that knows them, and NO_COLOR is not set.
bool has_colours(std::FILE* file);

/// The text in its tone where `file` has colours, else as it is.
std::string toned(std::FILE* file, Tone tone, const std::string& text);

}  // namespace trihedron::cli
