// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <string>
#include <vector>

#include "cli/command_texts.hpp"
#include "cli/commands.hpp"
#include "cli/shards.hpp"
#include "cli/terminal.hpp"
#include "cli/versions.hpp"
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
    "  trihedron calibrate shots/top shots/side shots/front --board 9x6 --square 20\n"
    "\n"
    "Options that repeat may stand in a file, a section per command, for --config:\n"
    "  [recognize]\n"
    "  models = \"parts\"\n"
    "\n"
    "Exit codes: 0 done, 1 found nothing or a check failed, 2 bad input or usage.\n"
    "`trihedron COMMAND --help` explains a command.";

int fail(const std::string& message) {
  std::fprintf(stderr, "%s %s\n", toned(stderr, Tone::kBad, "trihedron:").c_str(), message.c_str());
  return kBadInput;
}

/// CLI11's explanation on one line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

/// A message that lists the commands, where CLI11 only says that one is missing.
void check_command(const CLI::App& program, const std::vector<std::string>& words) {
  std::string names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (!words.empty() && command->get_name() == words[0]) return;
    if (!command->get_group().empty()) names += (names.empty() ? "" : ", ") + command->get_name();
  }
  if (words.empty()) throw trihedron::Error("no command given; expected " + names);
  if (words[0][0] != '-')
    throw trihedron::Error("unknown command " + words[0] + "; expected " + names);
}

/// The commands that make the manual page and the completions from what --help knows.
void add_texts(CLI::App& program) {
  program.add_subcommand("manual", "Print the manual page")->group("")->callback([&program] {
    std::fputs(manual_page(program, TRIHEDRON_VERSION).c_str(), stdout);
  });
  CLI::App* command = program.add_subcommand("completion", "Print a completion script")->group("");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash or zsh")->required();
  command->callback([&program, shell] { std::fputs(completion(program, *shell).c_str(), stdout); });
}

void add_everything(CLI::App& program, int& exit_code, std::vector<std::string>& next_words) {
  program.footer(kExamples);
  program.set_version_flag("--version", versions(), "Print the versions of program and tools");
  program.allow_config_extras(CLI::config_extras_mode::error);
  program.set_config("--config", "", "Read options from this file (TOML, a section per command)")
      ->type_name("FILE");
  program.require_subcommand(1);
  program.fallthrough();  // --config may stand behind the command, too
  add_recognize(program, exit_code);
  add_evaluate(program, exit_code);
  add_models(program, exit_code);
  add_render(program, exit_code);
  add_calibrate(program, exit_code);
  add_rig(program, exit_code);
  add_simulate(program, exit_code);
  add_verify(program, exit_code);
  add_merge(program, next_words);
  add_texts(program);
}

/// Runs one command line, without the program's name.
int run(std::vector<std::string> words) {
  CLI::App program(kAbout, "trihedron");
  int exit_code = kDone;
  std::vector<std::string> next_words;
  try {
    remember_command_line(words);
    add_everything(program, exit_code, next_words);
    check_command(program, words);
    std::reverse(words.begin(), words.end());  // CLI11 takes them off the end
    program.parse(words);
  } catch (const CLI::ConfigError& error) {
    return fail("--config: " + one_line(error.what()) +
                "; expected [COMMAND] and the names of its options without --");
  } catch (const CLI::ConversionError& error) {
    return fail(one_line(error.what()) +
                "; expected a value of the kind and size that --help says");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    return fail(one_line(error.what()) + "; see trihedron --help");
  } catch (const trihedron::Error& error) {
    return fail(error.what());
  } catch (const std::exception& error) {
    return fail(std::string("internal error: ") + error.what());
  }
  return next_words.empty() ? exit_code : run(next_words);
}

}  // namespace

int main(int argc, char** argv) {
  // One thread: results must not depend on the machine, and evaluate forks.
  cv::setNumThreads(1);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  return run({argv + 1, argv + argc});
}
