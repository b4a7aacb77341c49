// SPDX-License-Identifier: Apache-2.0
#include "cli/frame_statistics.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "golden/error.hpp"

namespace trihedron::cli {

FrameStatistics::FrameStatistics(const std::string& file) : file_(file) {
  if (file.empty()) return;
  out_.open(file);
  if (!out_) throw Error("--stats " + file + ": cannot be written; expected a writable path");
  const std::string ending = std::filesystem::path(file).extension().string();
  json_ = ending == ".json" || ending == ".jsonl";
  if (json_) return;
  out_ << "sequence,frame,view,width,height,contour_px,vertices,vertices_lost,status,clocks,"
          "latency_clocks,input_stalls,contour_stalls\n";
}

void FrameStatistics::add(const std::string& sequence, int id, const sim::FrameResult& frame,
                          std::size_t contour_pixels) {
  if (file_.empty()) return;
  const ViewFeatures& features = frame.features;
  const nlohmann::ordered_json line = {{"sequence", sequence},
                                       {"frame", id},
                                       {"view", frame.view},
                                       {"width", features.width},
                                       {"height", features.height},
                                       {"contour_px", contour_pixels},
                                       {"vertices", features.vertices.size()},
                                       {"vertices_lost", features.vertices_lost},
                                       {"status", frame.status},
                                       {"clocks", frame.clocks},
                                       {"latency_clocks", frame.latency_clocks},
                                       {"input_stalls", frame.input_stalls},
                                       {"contour_stalls", frame.contour_stalls}};
  if (json_) {
    out_ << line.dump();
  } else {
    const char* separator = "";
    for (const auto& value : line) {
      out_ << separator << (value.is_string() ? value.get<std::string>() : value.dump());
      separator = ",";
    }
  }
  out_ << "\n";
  if (!out_) throw Error("--stats " + file_ + ": the disk refuses; expected room for it");
}

}  // namespace trihedron::cli
