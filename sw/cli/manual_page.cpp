// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_texts.hpp"

namespace trihedron::cli {
namespace {

/// Plain text for troff: no escapes, no requests at a line's start, hyphens that can be copied.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
      out += std::string("\\&") + c;
    else
      out += c;
  }
  return out;
}

std::string as_typed(const std::string& text) { return ".nf\n" + plain(text) + "\n.fi\n"; }

std::string entry(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + ("\\fB" + plain(name) + "\\fR");
  if (!option.value.empty() && option.names.front()[0] == '-')
    names += " \\fI" + plain(option.value) + "\\fR";
  std::string help = plain(option.help);
  if (!option.choices.empty())
    help += plain(fmt::format("; one of {}", fmt::join(option.choices, ", ")));
  if (!option.default_value.empty()) help += plain(" (default: " + option.default_value + ")");
  return ".TP\n" + names + "\n" + help + "\n";
}

std::string section(const CommandText& command) {
  std::string usage = "\\fBtrihedron " + plain(command.name) + "\\fR";
  for (const OptionText& argument : command.arguments)
    usage += " \\fI" + plain(argument.names.front()) + "\\fR";
  std::string out = ".SS " + plain(command.name) + "\n" + usage + " [\\fIoptions\\fR]\n.PP\n" +
                    plain(command.about) + ".\n";
  for (const OptionText& argument : command.arguments) out += entry(argument);
  for (const OptionText& option : command.options) out += entry(option);
  if (!command.footer.empty()) out += ".PP\n" + as_typed(command.footer);
  return out;
}

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& version) {
  const std::vector<CommandText> commands = command_texts(program);
  const CommandText& whole = commands.front();
  std::string out = ".TH TRIHEDRON 1 \"\" \"trihedron " + plain(version) +
                    "\" \"User Commands\"\n" +
                    ".SH NAME\ntrihedron \\- polyhedral objects from three camera views\n" +
                    ".SH SYNOPSIS\n\\fBtrihedron\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n" +
                    ".SH DESCRIPTION\n" + plain(whole.about) + "\n.SH OPTIONS\n";
  for (const OptionText& option : whole.options) out += entry(option);
  out += ".SH COMMANDS\n";
  for (std::size_t i = 1; i < commands.size(); ++i) out += section(commands[i]);
  out += ".SH EXAMPLES AND EXIT STATUS\n" + as_typed(whole.footer);
  out += ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nNo colours, on a terminal either.\n";
  return out;
}

}  // namespace trihedron::cli
