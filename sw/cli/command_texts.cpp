// SPDX-License-Identifier: Apache-2.0
#include "cli/command_texts.hpp"

namespace trihedron::cli {
namespace {

/// "rtl", "golden" of "TEXT:{rtl,golden}".
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionText text_of(const CLI::Option& option) {
  OptionText out;
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  if (option.get_positional()) out.names = {option.get_name(true)};
  const std::string type = option.get_type_name();
  out.choices = choices_of(type);
  out.value = option.get_items_expected_max() == 0 ? "" : type.substr(0, type.find(':'));
  out.help = option.get_description();
  out.default_value = option.get_default_str();
  return out;
}

CommandText text_of(const CLI::App& command) {
  CommandText out{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    (option->get_positional() ? out.arguments : out.options).push_back(text_of(*option));
  }
  return out;
}

}  // namespace

std::vector<CommandText> command_texts(const CLI::App& program) {
  std::vector<CommandText> out{text_of(program)};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) out.push_back(text_of(*command));
  return out;
}

}  // namespace trihedron::cli
