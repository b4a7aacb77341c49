// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_texts.hpp"
#include "golden/error.hpp"

namespace trihedron::cli {
namespace {

std::string names_of(const CommandText& command) {
  std::string out;
  for (const OptionText& option : command.options)
    out += fmt::format("{}{}", out.empty() ? "" : " ", fmt::join(option.names, " "));
  return out;
}

std::string bash_case(const CommandText& command) {
  std::string out = fmt::format("    {})\n", command.name);
  std::string values;
  for (const OptionText& option : command.options)
    if (!option.choices.empty())
      values += fmt::format("        {}) words='{}' ;;\n", fmt::join(option.names, "|"),
                            fmt::join(option.choices, " "));
    else if (!option.value.empty())
      values += fmt::format("        {}) return ;;\n", fmt::join(option.names, "|"));
  out += fmt::format("      words='{}'\n", names_of(command));
  if (!values.empty()) out += "      case $before in\n" + values + "      esac\n";
  return out + "      ;;\n";
}

/// Values of options and arguments are left to the shell's completion of file names.
std::string bash(const std::vector<CommandText>& commands) {
  std::string names, cases;
  for (std::size_t i = 1; i < commands.size(); ++i) {
    names += (i == 1 ? "" : " ") + commands[i].name;
    cases += bash_case(commands[i]);
  }
  return fmt::format(R"(# Completion for bash, as `trihedron completion bash` prints it.
_trihedron() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} words=
  COMPREPLY=()
  case ${{COMP_WORDS[1]}} in
{}    *) words='{} {}' ;;
  esac
  if [[ $word == -* || $COMP_CWORD -eq 1 || $words != *--* ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  fi
}}
complete -o default -F _trihedron trihedron
)",
                     cases, names_of(commands.front()), names);
}

/// Text inside the quoted specifications of _arguments and _describe.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

std::string zsh_options(const CommandText& command) {
  std::string out;
  for (const OptionText& option : command.options)
    for (const std::string& name : option.names) {
      const std::string values =
          option.choices.empty() ? "_files" : fmt::format("({})", fmt::join(option.choices, " "));
      out += fmt::format(
          " \\\n        '{}[{}]{}'", name, zsh_text(option.help),
          option.value.empty() ? "" : fmt::format(":{}:{}", zsh_text(option.value), values));
    }
  return out;
}

std::string zsh(const std::vector<CommandText>& commands) {
  std::string names, cases;
  for (std::size_t i = 1; i < commands.size(); ++i) {
    const CommandText& command = commands[i];
    names += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.about));
    cases += fmt::format("    {})\n      _arguments{} \\\n        '*:{}:_files'\n      ;;\n",
                         command.name, zsh_options(command),
                         command.arguments.empty() ? "file" : command.arguments[0].names[0]);
  }
  return fmt::format(R"(#compdef trihedron
# Completion for zsh, as `trihedron completion zsh` prints it.
local -a commands
commands=(
{})
if (( CURRENT == 2 )); then
  _describe command commands
  _arguments{}
else
  shift words
  (( CURRENT-- ))
  case $words[1] in
{}  esac
fi
)",
                     names, zsh_options(commands.front()), cases);
}

}  // namespace

std::string completion(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bash(command_texts(program));
  if (shell == "zsh") return zsh(command_texts(program));
  throw Error("completion: unknown shell " + shell + "; expected bash or zsh");
}

}  // namespace trihedron::cli
