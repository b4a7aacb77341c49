// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluation_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "report/page.hpp"

namespace trihedron::cli {

namespace fs = std::filesystem;
using report::Json;

void check_report_scenes(const std::vector<std::string>& choices,
                         const std::vector<fs::path>& scenes) {
  for (const std::string& choice : choices) {
    if (choice == "failed" || choice == "all") continue;
    const bool known = std::any_of(scenes.begin(), scenes.end(),
                                   [&](const fs::path& s) { return s.filename() == choice; });
    if (!known)
      throw Error("--report-scenes " + choice +
                  ": no such scene in the data set; expected failed, all or names of scenes");
  }
}

void write_evaluation_report(const std::string& file, const std::string& dataset,
                             const std::vector<SceneOutcome>& outcomes) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // browsers open this in seconds
  report::PageContent content;
  content.title = "Evaluation of " + fs::path(dataset / fs::path()).parent_path().string();
  content.program = "trihedron " TRIHEDRON_VERSION;
  Json lines = Json::array();
  std::size_t bytes = 0, left_out = 0;
  for (const SceneOutcome& outcome : outcomes) {
    Json report = Json::parse(outcome.report);
    report["line"]["full"] = -1;
    const bool fits = bytes + outcome.report.size() <= kMostBytes;
    if (!report["scene"].is_null() && fits) {
      report["line"]["full"] = content.scenes.size();
      content.scenes.push_back(std::move(report["scene"]));
      bytes += outcome.report.size();
    } else if (!report["scene"].is_null()) {
      ++left_out;
    }
    lines.push_back(std::move(report["line"]));
  }
  std::string note =
      fmt::format("{} of {} scenes can be opened in full{}; --report-scenes chooses which.",
                  content.scenes.size(), outcomes.size(),
                  left_out > 0 ? fmt::format(", {} more would make the page too large", left_out)
                               : std::string());
  if (content.scenes.empty() && left_out == 0)
    note = "No scene is shown in full, as none failed; --report-scenes chooses others.";
  content.overview = {{"lines", lines}, {"note", note}};
  write_whole(file, report::make_page(content));
}

}  // namespace trihedron::cli
