// SPDX-License-Identifier: Apache-2.0
#include "cli/verify_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/file.hpp"

namespace trihedron::cli {
namespace {

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

nlohmann::json hit_bins(const sim::FunctionalCoverage& coverage) {
  nlohmann::json out = nlohmann::json::object();
  for (const auto& [group, bins] : coverage.groups()) {
    for (const auto& [bin, hits] : bins) {
      if (hits > 0) out[group][bin] = hits;
    }
  }
  return out;
}

void add_bins(const nlohmann::json& hits, sim::FunctionalCoverage& coverage) {
  for (const auto& [group, bins] : hits.items()) {
    for (const auto& [bin, count] : bins.items()) coverage.add(group, bin, count);
  }
}

}  // namespace

std::string CaseOutcome::to_text() const {
  return nlohmann::json{seed,
                        seconds,
                        clocks,
                        compared.frames,
                        compared.beats,
                        compared.records,
                        compared.registers,
                        failure,
                        skipped,
                        hit_bins(covered)}
      .dump();
}

CaseOutcome CaseOutcome::from_text(const std::string& text) {
  const nlohmann::json o = nlohmann::json::parse(text);
  CaseOutcome outcome{o[0], o[1], o[2], {o[3], o[4], o[5], o[6]}, o[7], o[8], {}};
  add_bins(o[9], outcome.covered);
  return outcome;
}

void write_junit(const std::string& file, const std::vector<CaseOutcome>& outcomes,
                 const std::function<std::string(const CaseOutcome&)>& repeat) {
  std::string out;
  std::size_t failures = 0, skipped = 0;
  double seconds = 0.0;
  for (const CaseOutcome& outcome : outcomes) {
    failures += !outcome.failure.empty();
    skipped += outcome.skipped;
    seconds += outcome.seconds;
  }
  out += fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"trihedron verify\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" "
      "time=\"{:.3f}\">\n",
      outcomes.size(), failures, skipped, seconds);
  for (const CaseOutcome& outcome : outcomes) {
    out += fmt::format("  <testcase classname=\"verify\" name=\"seed {}\" time=\"{:.3f}\">",
                       outcome.seed, outcome.seconds);
    if (outcome.skipped) out += "<skipped/>";
    if (!outcome.failure.empty()) {
      out += fmt::format("<failure message=\"{}\">repeat: {}</failure>",
                         xml_escaped(outcome.failure), xml_escaped(repeat(outcome)));
    }
    out += "</testcase>\n";
  }
  write_whole(file, out + "</testsuite>\n");
}

void write_coverage(const std::string& file, const std::vector<CaseOutcome>& outcomes) {
  sim::FunctionalCoverage all;
  std::uint64_t frames = 0;
  for (const CaseOutcome& outcome : outcomes) {
    add_bins(hit_bins(outcome.covered), all);
    frames += outcome.compared.frames;
  }
  const nlohmann::ordered_json document = {{"first_seed", outcomes.front().seed},
                                           {"cases", outcomes.size()},
                                           {"frames", frames},
                                           {"groups", all.groups()}};
  write_whole(file, document.dump(1) + "\n");
}

}  // namespace trihedron::cli
