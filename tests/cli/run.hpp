// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <regex>
#include <string>

#include "io/file.hpp"
#include "scratch.hpp"

namespace trihedron {

/// What a run of the program left behind.
struct Run {
  int exit_code = -1;
  std::string out, err;
};

/// Runs the built program with `arguments` as a shell would split them.
inline Run run_program(const std::string& arguments) {
  const Scratch scratch;
  const std::string out = (scratch / "out").string(), err = (scratch / "err").string();
  const int status = std::system(
      (std::string(TRIHEDRON_BINARY) + " " + arguments + " >" + out + " 2>" + err).c_str());
  Run run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.out = read_whole(out, "output");
  run.err = read_whole(err, "errors");
  return run;
}

/// Whether the text is exactly one line.
inline bool is_one_line(const std::string& text) {
  return !text.empty() && text.find('\n') == text.size() - 1;
}

/// A results file without its last column, the time.
inline std::string without_times(const std::string& csv) {
  return std::regex_replace(csv, std::regex(",[^,\n]*\n"), "\n");
}

inline const std::string kModels = TRIHEDRON_TESTVECTORS "/models10";
inline const std::string kScenes = TRIHEDRON_TESTVECTORS "/scenes";
inline const std::string kStudioScene = kScenes + "/studio-two/000034";

}  // namespace trihedron
