// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "io/views.hpp"
#include "recognition/recognize.hpp"
#include "report/hardware_activity.hpp"

namespace trihedron::cli {

/// The options that recognize and evaluate share.
struct RecognitionArguments {
  std::string models;
  std::string front_end;
  std::string method = "full";

  /// Adds --models, --frontend and --method to a command.
  void add_to(CLI::App& command);

  RecognitionOptions options() const;
  /// Where the RTL is simulated, each call stores in `activity`, unless null, what it counted.
  FrontEnd make_front_end(report::HardwareActivity* activity = nullptr) const;

  /// The library: --models, else a folder "models" beside `input` or up to two levels above it.
  /// Throws Error when there is neither.
  std::vector<Model> library(const std::filesystem::path& input) const;
};

}  // namespace trihedron::cli
