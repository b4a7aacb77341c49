// SPDX-License-Identifier: Apache-2.0
#include "cli/recognition_options.hpp"

#include "cli/rtl_front_end.hpp"
#include "golden/error.hpp"
#include "io/library.hpp"

namespace trihedron::cli {

void RecognitionArguments::add_to(CLI::App& command) {
  front_end = default_front_end();
  command.add_option("--models", models, "Folder of meshes (PLY, OBJ, STL, OFF; mm)")
      ->type_name("DIR");
  command
      .add_option("--frontend", front_end,
                  "Features from the simulated RTL or from the golden model, bit for bit the same")
      ->check(CLI::IsMember({"rtl", "golden"}))
      ->capture_default_str();
  command.add_option("--method", method, "The product, or the source method as published")
      ->check(CLI::IsMember({"full", "paper"}))
      ->capture_default_str();
}

RecognitionOptions RecognitionArguments::options() const {
  RecognitionOptions out;
  out.method = method == "paper" ? Method::kPaper : Method::kFull;
  return out;
}

FrontEnd RecognitionArguments::make_front_end(report::HardwareActivity* activity) const {
  return front_end == "rtl" ? rtl_front_end(activity) : golden_front_end();
}

std::vector<Model> RecognitionArguments::library(const std::filesystem::path& input) const {
  if (!models.empty()) return read_library(models);
  std::filesystem::path folder = std::filesystem::absolute(input / "").lexically_normal();
  constexpr int kLevels = 4;  // the folder itself (its path ends in a slash), and three above
  for (int level = 0; level < kLevels; ++level) {
    if (std::filesystem::is_directory(folder / "models")) return read_library(folder / "models");
    folder = folder.parent_path();
  }
  throw Error("--models: missing, and there is no folder \"models\" near " + input.string() +
              "; expected a folder of meshes");
}

}  // namespace trihedron::cli
