// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "io/views.hpp"
#include "recognition/recognize.hpp"

namespace trihedron::cli {

/// The options that recognize and evaluate share.
struct RecognitionArguments {
  std::string models;
  std::string front_end;
  std::string method = "full";

  /// Adds --models, --frontend and --method to a command.
  void add_to(CLI::App& command);

  RecognitionOptions options() const;
  FrontEnd make_front_end() const;

  /// The library: --models, else a folder "models" beside `input` or up to two levels above it.
  /// Throws Error when there is neither.
  std::vector<Model> library(const std::filesystem::path& input) const;
};

}  // namespace trihedron::cli
