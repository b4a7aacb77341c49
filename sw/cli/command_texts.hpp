// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace trihedron::cli {

/// What --help says of an option, an argument or a flag.
struct OptionText {
  std::vector<std::string> names;  ///< "--out"; of an argument its name, "SCENE"
  std::string value;               ///< "DIR"; empty: a flag
  std::string help;
  std::string default_value;
  std::vector<std::string> choices;  ///< the values it takes, if there are only these
};

/// What --help says of a command: the one source of manual page and completions.
struct CommandText {
  std::string name, about, footer;
  std::vector<OptionText> arguments, options;
};

/// The program itself first, then its commands without the hidden ones.
std::vector<CommandText> command_texts(const CLI::App& program);

/// The manual page (man macros), section 1.
std::string manual_page(const CLI::App& program, const std::string& version);

/// A completion script. Throws Error unless `shell` is "bash" or "zsh".
std::string completion(const CLI::App& program, const std::string& shell);

}  // namespace trihedron::cli
