// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "cli/run.hpp"

using namespace trihedron;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::vector<std::string> kCommands = {
    "recognize", "evaluate", "models", "render", "calibrate", "rig", "simulate", "verify", "merge"};

/// The options that --help of a command lists.
std::set<std::string> options_of(const std::string& command) {
  const Run help = run_program(command + " --help");
  REQUIRE(help.exit_code == 0);
  std::set<std::string> out;
  const std::regex option("\n  (?:-[a-z],)?(--[a-z-]+)");
  for (auto it = std::sregex_iterator(help.out.begin(), help.out.end(), option);
       it != std::sregex_iterator(); ++it)
    out.insert((*it)[1]);
  REQUIRE(out.count("--help") == 1);
  return out;
}

/// What bash offers for the last of `words` after "trihedron".
std::string bash_offers(const std::string& words, int count) {
  const Scratch scratch;
  scratch.write("try.sh", "source <(" TRIHEDRON_BINARY " completion bash)\nCOMP_WORDS=(trihedron " +
                              words + ")\nCOMP_CWORD=" + std::to_string(count) +
                              "\n_trihedron\nprintf '%s\\n' \"${COMPREPLY[@]}\" >" +
                              (scratch / "offers").string() + "\n");
  REQUIRE(std::system(("bash " + (scratch / "try.sh").string()).c_str()) == 0);
  return "\n" + read_whole(scratch / "offers", "offers");
}

}  // namespace

TEST_CASE("every command has an example, and its options are in manual and completions") {
  const std::string manual = run_program("manual").out;
  const std::string bash = run_program("completion bash").out;
  const std::string zsh = run_program("completion zsh").out;
  CHECK_THAT(manual, StartsWith(".TH TRIHEDRON 1"));
  for (const std::string& command : kCommands) {
    INFO(command);
    CHECK_THAT(run_program(command + " --help").out, Contains("Example"));
    const auto start = manual.find(".SS " + command + "\n");
    REQUIRE(start != std::string::npos);
    const std::string page = manual.substr(start, manual.find("\n.SS ", start + 4) - start);
    const auto in_bash = bash.find("    " + command + ")\n"),
               in_zsh = zsh.find("    " + command + ")\n");
    REQUIRE(in_bash != std::string::npos);
    REQUIRE(in_zsh != std::string::npos);
    const std::string bash_part = bash.substr(in_bash, bash.find(";;\n    ", in_bash) - in_bash);
    const std::string zsh_part = zsh.substr(in_zsh, zsh.find("\n      ;;", in_zsh) - in_zsh);
    for (const std::string& option : options_of(command)) {
      INFO(option);
      CHECK_THAT(page, Contains(std::regex_replace(option, std::regex("-"), "\\-")));
      CHECK_THAT(bash_part, Contains(option));
      CHECK_THAT(zsh_part, Contains("'" + option + "["));
    }
  }
  CHECK(run_program("completion fish").exit_code == 2);
}

TEST_CASE("bash completes commands, options and fixed values, and leaves files to the shell") {
  CHECK_THAT(bash_offers("re", 1),
             Contains("\nrecognize\n") && Contains("\nrender\n") && !Contains("evaluate"));
  CHECK_THAT(bash_offers("recognize --mo", 2), Contains("\n--models\n") && !Contains("--method"));
  CHECK_THAT(bash_offers("evaluate scenes --frontend ''", 4), Contains("\nrtl\ngolden\n"));
  CHECK(bash_offers("recognize --out ''", 3) == "\n\n");
  CHECK(bash_offers("recognize ''", 2) == "\n\n");
}

TEST_CASE("a configuration file gives options that the command line leaves out") {
  const Scratch scratch;
  const std::string file =
      scratch
          .write("trihedron.toml", "[recognize]\nmodels = \"" + kModels +
                                       "\"\nfrontend = \"golden\"\n\n[evaluate]\njobs = 2\n")
          .string();
  for (const std::string& words : {"--config " + file + " recognize " + kStudioScene,
                                   "recognize " + kStudioScene + " --config " + file}) {
    const Run run = run_program(words + " --quiet");
    INFO(words << ": " << run.err);
    CHECK(run.exit_code == 0);
    CHECK(run.out.empty());
  }
  const Run beaten = run_program("recognize " + kStudioScene + " --models none --config " + file);
  CHECK_THAT(beaten.err, Contains("none: no such folder"));  // the command line wins
  scratch.write("trihedron.toml", "[recognize]\nmodls = \"x\"\n");
  const Run unknown = run_program("recognize " + kStudioScene + " --config " + file);
  CHECK(unknown.exit_code == 2);
  CHECK(is_one_line(unknown.err));
  CHECK_THAT(unknown.err, Contains("modls") && Contains("--config"));
  const Run missing = run_program("recognize " + kStudioScene + " --config /no/such/file");
  CHECK(missing.exit_code == 2);
  CHECK_THAT(missing.err, Contains("/no/such/file"));
}

TEST_CASE("the version option names the tools") {
  const std::string text = run_program("--version").out;
  for (const char* tool :
       {"trihedron 0.", "\nOpenCV 4.", "\nEigen 3.", "\ncompiler "})
    CHECK_THAT(text, Contains(tool));
}

TEST_CASE("colours only on a terminal that wants them") {
  CHECK(run_program("recognize none").err.find('\033') == std::string::npos);
  if (!std::filesystem::exists("/dev/pts/ptmx")) {
    WARN("this machine has no pseudo-terminals: what a terminal shows was not tested");
    return;
  }
  // script(1) gives the program a terminal.
  const std::string bad = std::string(TRIHEDRON_BINARY) + " recognize none";
  const auto on_terminal = [&](const std::string& setting) {
    const Scratch scratch;
    const std::string file = (scratch / "typescript").string();
    if (std::system(("TERM=xterm " + setting + " script -qec '" + bad + "' " + file +
                     " >/dev/null </dev/null")
                        .c_str()) == -1)
      return std::string("no script");
    return read_whole(file, "what was shown");
  };
  CHECK_THAT(on_terminal(""), Contains("\033[1;31mtrihedron:\033[0m none: no such folder"));
  CHECK_THAT(on_terminal("NO_COLOR=1"), Contains("trihedron: none") && !Contains("\033["));
  CHECK_THAT(on_terminal("TERM=dumb"), Contains("trihedron: none") && !Contains("\033["));
}
