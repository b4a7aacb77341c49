// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.hpp"

namespace trihedron::cli {
namespace {

/// Accepts the numbers that `good` accepts; `expected` says in words which those are.
CLI::Validator number(bool (*good)(double), const std::string& expected) {
  return CLI::Validator(
      [=](std::string& text) {
        double value = 0;
        const bool ok = CLI::detail::lexical_cast(text, value) && good(value);
        return ok ? std::string() : "is " + text + "; expected " + expected;
      },
      "");
}

}  // namespace

const CLI::Validator kPositive = number([](double value) { return value > 0; }, "a number above 0");
const CLI::Validator kNotNegative =
    number([](double value) { return value >= 0; }, "a number of 0 or more");

}  // namespace trihedron::cli
