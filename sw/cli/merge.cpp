// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/commands.hpp"
#include "cli/shards.hpp"

namespace trihedron::cli {

void add_merge(CLI::App& program, std::vector<std::string>& next_words) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand(
      "merge",
      "Join the shards of evaluate, verify or simulate as if the work had been done at once");
  command->add_option("RESULTS", *folder, "The shards' --results folder")->required();
  command->footer(
      "Example:\n"
      "  trihedron evaluate testvectors/scenes --models testvectors/models10 \\\n"
      "    --csv results.csv --shard 1/2 --results shards      (and 2/2, on any machine)\n"
      "  trihedron merge shards\n"
      "\n"
      "Writes and prints what the command without --shard would have, the options it was given\n"
      "included, and returns its exit code. Only times differ.");
  command->callback([folder, &next_words] { next_words = merging_command_line(*folder); });
}

}  // namespace trihedron::cli
