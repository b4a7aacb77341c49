// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trihedron::cli {

/// Work that several machines share: shard I of N does items I-1, I-1+N ... and stores what came
/// out in a folder; `trihedron merge` runs the same command once more with all items from there.
struct ShardArguments {
  std::string shard;    ///< "2/4"; empty: all the work
  std::string results;  ///< folder
  bool merge = false;   ///< take every item from `results`

  /// Adds --shard and --results to a command.
  void add_to(CLI::App& command);
};

/// As run_workers(), or, sharded, nothing: the shard's texts are stored in one file, which appears
/// when it is whole. A shard that is stored already is not run again. With `merge` the texts of
/// all shards. Throws Error on a shard that is none, when results of another command line are
/// there, or (merge) when shards are missing.
std::optional<std::vector<std::string>> run_sharded(
    std::size_t count, int jobs, const std::string& what, const ShardArguments& shard,
    const std::function<std::string(std::size_t)>& work);

/// The command line, which identifies the work of a shard: call first.
void remember_command_line(const std::vector<std::string>& words);

/// The command line whose shards are in the folder, as it must run to merge them; moves to the
/// folder where it ran. Throws Error when there are none, or shards of several command lines.
std::vector<std::string> merging_command_line(const std::string& folder);

}  // namespace trihedron::cli
