// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace trihedron::cli {

/// What a command returns to the shell.
enum ExitCode : int {
  kDone = 0,
  kNothingFound = 1,  ///< it ran, but found nothing or a check failed
  kBadInput = 2,      ///< bad input or usage
};

// Checks of numeric options, with a message for a person.
extern const CLI::Validator kPositive;
extern const CLI::Validator kNotNegative;

// Each adds one command to the program. When the command line names it, its callback does the
// work and stores the exit code; it throws Error on bad input.
void add_recognize(CLI::App& program, int& exit_code);
void add_evaluate(CLI::App& program, int& exit_code);
void add_models(CLI::App& program, int& exit_code);
void add_render(CLI::App& program, int& exit_code);
void add_calibrate(CLI::App& program, int& exit_code);
void add_rig(CLI::App& program, int& exit_code);
void add_simulate(CLI::App& program, int& exit_code);
void add_verify(CLI::App& program, int& exit_code);

/// `merge` stores the command line that the program shall run in its place.
void add_merge(CLI::App& program, std::vector<std::string>& next_words);

}  // namespace trihedron::cli
