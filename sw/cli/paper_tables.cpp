// SPDX-License-Identifier: Apache-2.0
#include "cli/paper_tables.hpp"

#include <fmt/format.h>

#include "golden/error.hpp"

namespace trihedron::cli {
namespace {

/// "3/5 surfaces": of how many regions.
std::string surfaces_table(const PaperTrace& trace) {
  constexpr std::array<const char*, 3> kViews = {"top", "side", "front"};
  std::string out = "Table 1. Surfaces described in 3D\n";
  for (std::size_t role = 0; role < 3; ++role) {
    std::string names;
    for (const CrossedSurface& s : trace.surfaces) {
      if (static_cast<std::size_t>(s.role) == role) names += " " + paper_name(s);
    }
    out += fmt::format("  {:<6} {:>2} regions:{}\n", kViews[role], trace.regions[role],
                       names.empty() ? " -" : names);
  }
  return out + fmt::format(
                   "  not described: {} in pieces, {} without a partner, {} not planar, {} "
                   "contradicted, {} duplicates; Error {:.2f} mm\n",
                   trace.in_pieces, trace.incomplete, trace.not_planar, trace.contradicted,
                   trace.duplicates, trace.error_mm);
}

std::string hypotheses_table(const PaperTrace& trace, const std::vector<Model>& library) {
  std::string out = "Table 2. Hypotheses V_i = (model; its surfaces)\n";
  for (std::size_t i = 0; i < trace.surfaces.size(); ++i) {
    out += fmt::format("  {:<4}", paper_name(trace.surfaces[i]));
    for (const PaperHypothesis& h : trace.hypotheses[i]) {
      out += fmt::format(" ({};", library[static_cast<std::size_t>(h.model)].id);
      for (const int s : h.surfaces) out += fmt::format(" {}", s);
      out += ")";
    }
    out += trace.hypotheses[i].empty() ? " -\n" : "\n";
  }
  return out;
}

/// A row per model of the priority list, a column per scene surface.
std::string verification_table(const PaperTrace& trace, const std::vector<Model>& library) {
  std::string out = "Tables 3, 4. Verification, in order of priority: model surface per surface\n";
  out += "  model";
  for (const CrossedSurface& s : trace.surfaces) out += fmt::format("{:>4}", paper_name(s));
  out += "   outline\n";
  for (const PaperIdentification& id : trace.priority_list) {
    std::vector<std::string> cells(trace.surfaces.size(), "-");
    for (const PaperMatch& m : id.matches) {
      cells[static_cast<std::size_t>(m.scene_surface)] = std::to_string(m.model_surface);
    }
    out += fmt::format("  {:>5}", library[static_cast<std::size_t>(id.model)].id);
    for (const std::string& cell : cells) out += fmt::format("{:>4}", cell);
    const CornerSupport& s = id.position.support;
    out += fmt::format("   {:>2}/{:<2}  {}\n", s.found, s.outline,
                       id.accepted ? "accepted" : id.reason);
  }
  return out;
}

std::string recognition_table(const PaperTrace& trace, const std::vector<Model>& library) {
  std::string out = "Tables 5, 6. Recognised objects and their positioning error\n";
  bool any = false;
  for (const PaperIdentification& id : trace.priority_list) {
    if (!id.accepted) continue;
    any = true;
    const Model& model = library[static_cast<std::size_t>(id.model)];
    out += fmt::format("  model {} {}: ({};", model.id, model.name, model.id);
    for (const PaperMatch& m : id.matches) out += fmt::format(" {}", m.model_surface);
    out += fmt::format("), d = {:.2f} mm\n", id.position.error_mm);
  }
  if (!any) out += "  none\n";
  return out + fmt::format("  identification and positioning: {:.2f} ms\n", 1e3 * trace.seconds);
}

}  // namespace

std::string paper_tables(const std::string& scene, const PaperTrace& trace,
                         const std::vector<Model>& library) {
  return fmt::format("scene {}\n", scene) + surfaces_table(trace) +
         hypotheses_table(trace, library) + verification_table(trace, library) +
         recognition_table(trace, library);
}

RecognitionResult recognize_with_tables(const std::string& scene, const std::vector<View>& views,
                                        const Recognizer& recognizer,
                                        const RecognitionOptions& options, std::string* tables) {
  if (!tables) return recognizer.recognize(views, options);
  if (options.method != Method::kPaper) {
    throw Error("--tables: only method paper has them; expected --method paper");
  }
  PaperTrace trace;
  const RecognitionResult result = recognize_paper(views, recognizer.library(), options, &trace);
  *tables = paper_tables(scene, trace, recognizer.library());
  return result;
}

}  // namespace trihedron::cli
