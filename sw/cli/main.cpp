// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "cli/commands.hpp"
#include "golden/error.hpp"

namespace {

using namespace trihedron::cli;

constexpr const char* kAbout =
    "Recognises and locates polyhedral objects from three calibrated camera views,\n"
    "through a simulated streaming hardware front end.";

constexpr const char* kExamples =
    "Examples:\n"
    "  trihedron recognize testvectors/scenes/studio-two/000034 --models testvectors/models10\n"
    "  trihedron evaluate testvectors/scenes --models testvectors/models10 --csv results.csv\n"
    "  trihedron models testvectors/models10\n"
    "  trihedron simulate testvectors/scenes/studio-two/000034 --check\n"
    "  trihedron verify --frames 1000 --jobs 2\n"
    "\n"
    "Exit codes: 0 done, 1 found nothing or a check failed, 2 bad input or usage.\n"
    "`trihedron COMMAND --help` explains a command.";

int fail(const std::string& message) {
  std::fprintf(stderr, "trihedron: %s\n", message.c_str());
  return kBadInput;
}

/// CLI11's explanation on one line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

/// A message that lists the commands, where CLI11 only says that one is missing.
void check_command(const CLI::App& program, int argc, char** argv) {
  std::string names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (argc > 1 && command->get_name() == argv[1]) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  if (argc < 2) throw trihedron::Error("no command given; expected " + names);
  if (argv[1][0] != '-')
    throw trihedron::Error(std::string("unknown command ") + argv[1] + "; expected " + names);
}

}  // namespace

int main(int argc, char** argv) {
  // One thread: results must not depend on the machine, and evaluate forks.
  cv::setNumThreads(1);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  CLI::App program(kAbout, "trihedron");
  program.footer(kExamples);
  program.set_version_flag("--version", "trihedron " TRIHEDRON_VERSION);
  program.require_subcommand(1);
  int exit_code = kDone;
  add_recognize(program, exit_code);
  add_evaluate(program, exit_code);
  add_models(program, exit_code);
  add_render(program, exit_code);
  add_calibrate(program, exit_code);
  add_rig(program, exit_code);
  add_simulate(program, exit_code);
  add_verify(program, exit_code);
  try {
    check_command(program, argc, argv);
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    return fail(one_line(error.what()) + "; see trihedron --help");
  } catch (const trihedron::Error& error) {
    return fail(error.what());
  } catch (const std::exception& error) {
    return fail(std::string("internal error: ") + error.what());
  }
  return exit_code;
}
