// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal.hpp"

#include <unistd.h>

#include <cstdlib>

namespace trihedron::cli {

bool has_colours(std::FILE* file) {
  const char* const no_colour = std::getenv("NO_COLOR");  // no-color.org: set and not empty
  if (no_colour != nullptr && *no_colour != '\0') return false;
  const char* const terminal = std::getenv("TERM");
  return isatty(fileno(file)) != 0 && terminal != nullptr && std::string(terminal) != "dumb";
}

std::string toned(std::FILE* file, Tone tone, const std::string& text) {
  if (!has_colours(file)) return text;
  constexpr const char* kCodes[] = {"32", "1;31", "2", "1"};
  return std::string("\033[") + kCodes[static_cast<int>(tone)] + "m" + text + "\033[0m";
}

}  // namespace trihedron::cli
