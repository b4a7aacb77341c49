// SPDX-License-Identifier: Apache-2.0
#include "cli/shards.hpp"

#include <fmt/format.h>

#include <zlib.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/workers.hpp"
#include "golden/error.hpp"
#include "io/file.hpp"

namespace trihedron::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<std::string> command_line;  // NOLINT: set once, before the work

struct Shard {
  std::size_t index = 1, count = 1;
};

Shard parse_shard(const std::string& text) {
  unsigned long index = 0, count = 0;
  char end = 0;
  constexpr unsigned long kMost = 1000000;
  if (std::sscanf(text.c_str(), "%lu/%lu%c", &index, &count, &end) != 2 || index < 1 ||
      index > count || count > kMost)
    throw Error("--shard: is " + text + "; expected I/N with I from 1 to N, such as 2/4");
  return {index, count};
}

/// The words that say what is computed: not which part of it, nor how many processes do it.
std::vector<std::string> job_of(const std::vector<std::string>& words) {
  const std::vector<std::string> left_out = {"--shard", "--results", "--jobs"};
  std::vector<std::string> out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (std::find(left_out.begin(), left_out.end(), name) == left_out.end())
      out.push_back(words[i]);
    else if (name == words[i])
      ++i;  // its value is the next word
  }
  return out;
}

json header_of(const Shard& shard, std::size_t items) {
  return {{"trihedron", TRIHEDRON_VERSION},
          {"command_line", job_of(command_line)},
          {"folder", fs::current_path().string()},
          {"shard", shard.index},
          {"of", shard.count},
          {"items", items}};
}

fs::path file_of(const std::string& folder, const Shard& shard) {
  return fs::path(folder) / fmt::format("shard-{:06}-of-{:06}.jsonl", shard.index, shard.count);
}

std::string checksum_line(const std::string& lines) {
  const auto* bytes = reinterpret_cast<const Bytef*>(lines.data());
  return json{{"crc32", crc32_z(0, bytes, lines.size())}}.dump() + "\n";
}

void write_shard(const fs::path& file, const json& header, const std::vector<json>& items) {
  std::string lines = header.dump() + "\n";
  for (const json& item : items) lines += item.dump() + "\n";
  write_whole(file, lines + checksum_line(lines));
}

/// A stored shard: the header, then a text per item. The checksum in its last line vouches for
/// all of it.
std::vector<json> read_shard(const fs::path& file) {
  const std::string text = read_whole(file, "the results of a shard");
  const std::size_t end = text.rfind('\n', text.size() < 2 ? 0 : text.size() - 2);
  const std::string lines = text.substr(0, end == std::string::npos ? 0 : end + 1);
  if (lines.empty() || text != lines + checksum_line(lines))
    throw Error(
        file.string() +
        ": damaged; expected a file as --shard wrote it, remove it and run the shard again");
  std::vector<json> out;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) out.push_back(json::parse(line));
  return out;
}

std::vector<fs::path> shard_files(const std::string& folder) {
  require_folder(folder, "the results of shards");
  std::vector<fs::path> out;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.compare(0, 6, "shard-") == 0 && entry.path().extension() == ".jsonl")
      out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  if (out.empty())
    throw Error(folder + ": no shard in this folder; expected shard-000001-of-00000N.jsonl ...");
  return out;
}

std::vector<std::string> merged(const std::string& folder, std::size_t count) {
  std::vector<std::string> texts(count);
  std::vector<bool> have(count);
  std::size_t shards = 0;
  std::vector<bool> present;
  for (const fs::path& file : shard_files(folder)) {
    const std::vector<json> lines = read_shard(file);
    shards = lines[0].at("of").get<std::size_t>();
    present.resize(shards);
    present.at(lines[0].at("shard").get<std::size_t>() - 1) = true;
    if (lines[0].at("items") != count)
      throw Error(
          fmt::format("{}: holds a part of {} items, but there are {} now; expected the same "
                      "input: run the shards again in an empty folder",
                      file.string(), lines[0].at("items").get<std::size_t>(), count));
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const auto item = lines[i].at("item").get<std::size_t>();
      texts.at(item) = lines[i].at("text").get<std::string>();
      have.at(item) = true;
    }
  }
  std::string missing;
  for (std::size_t i = 0; i < shards; ++i)
    if (!present[i]) missing += fmt::format(" {}/{}", i + 1, shards);
  if (!missing.empty())
    throw Error(folder + ": not finished:" + missing + "; expected every shard, run these first");
  if (std::find(have.begin(), have.end(), false) != have.end())
    throw Error(folder + ": an item is in no shard; run the shards again in an empty folder");
  return texts;
}

void run_shard(std::size_t count, int jobs, const std::string& what, const ShardArguments& shard,
               const std::function<std::string(std::size_t)>& work) {
  const Shard part = parse_shard(shard.shard);
  const fs::path file = file_of(shard.results, part);
  const json header = header_of(part, count);
  make_folder(shard.results);
  if (fs::exists(file)) {
    if (read_shard(file)[0] != header)
      throw Error(file.string() +
                  ": holds results of another command line, folder or version; "
                  "expected an empty --results, or the same command");
    fmt::print("shard {}: done before, {}\n", shard.shard, file.string());
    return;
  }
  std::vector<std::size_t> items;
  for (std::size_t i = part.index - 1; i < count; i += part.count) items.push_back(i);
  const std::vector<std::string> texts =
      run_workers(items.size(), jobs, what, [&](std::size_t i) { return work(items[i]); });
  std::vector<json> stored;
  for (std::size_t i = 0; i < items.size(); ++i)
    stored.push_back({{"item", items[i]}, {"text", texts[i]}});
  write_shard(file, header, stored);
  fmt::print("shard {}: {} of {} {}, {}\n", shard.shard, items.size(), count, what, file.string());
}

}  // namespace

void ShardArguments::add_to(CLI::App& command) {
  CLI::Option* part =
      command.add_option("--shard", shard, "Do only part I of N, for `merge` to join")
          ->type_name("I/N");
  CLI::Option* folder =
      command.add_option("--results", results, "With --shard: where the parts' results are kept")
          ->type_name("DIR");
  part->needs(folder);
  CLI::Option* joined = command.add_flag("--merge-shards", merge)->group("");  // set by merge
  joined->needs(folder);
}

std::optional<std::vector<std::string>> run_sharded(
    std::size_t count, int jobs, const std::string& what, const ShardArguments& shard,
    const std::function<std::string(std::size_t)>& work) {
  if (shard.merge) return merged(shard.results, count);
  if (shard.shard.empty()) {
    if (!shard.results.empty()) throw Error("--results: needs --shard; expected --shard I/N");
    return run_workers(count, jobs, what, work);
  }
  run_shard(count, jobs, what, shard, work);
  return std::nullopt;
}

void remember_command_line(const std::vector<std::string>& words) { command_line = words; }

std::vector<std::string> merging_command_line(const std::string& folder) {
  json first;
  for (const fs::path& file : shard_files(folder)) {
    json header = read_shard(file)[0];
    header.erase("shard");
    if (first.is_null()) first = header;
    if (header != first)
      throw Error(file.string() +
                  ": from another command line, folder, version or number of shards "
                  "than the other files; expected the shards of one command");
  }
  std::vector<std::string> words = first.at("command_line").get<std::vector<std::string>>();
  words.insert(words.end(), {"--results", fs::absolute(folder).string(), "--merge-shards"});
  const std::string ran_in = first.at("folder");
  std::error_code error;
  fs::current_path(ran_in, error);
  if (error)
    throw Error(folder + ": the shards ran in " + ran_in +
                ", which is not there; expected it here");
  return words;
}

}  // namespace trihedron::cli
