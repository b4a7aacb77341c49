// SPDX-License-Identifier: Apache-2.0
#include "recognition/pose_search.hpp"

#include <chrono>
#include <string>

#include "recognition/remaining_lines.hpp"

namespace trihedron {
namespace {

/// Counts and times the stages of a search.
class Clock {
 public:
  explicit Clock(std::vector<StageStatistics>& stages) : stages_(stages) {}

  void stage(const std::string& name, std::size_t count) {
    const auto now = std::chrono::steady_clock::now();
    stages_.push_back(
        {name, static_cast<int>(count), std::chrono::duration<double>(now - last_).count()});
    last_ = now;
  }

 private:
  std::vector<StageStatistics>& stages_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

PoseSearch search_poses(const std::vector<View>& views, const std::vector<Model>& library,
                        const LibraryIndex& index, const HypothesisOptions& options) {
  PoseSearch out;
  Clock clock(out.stages);
  std::size_t segments = 0;
  for (const View& v : views) {
    out.edgels.push_back(find_edgels(v.features));
    out.lines.push_back(find_lines(v, out.edgels.back()));
    segments += out.lines.back().segments.size();
  }
  clock.stage("segments", segments);
  out.edges = cross_edges(out.lines);
  clock.stage("crossing", out.edges.size());
  out.hypotheses = find_hypotheses(out.lines, out.edges, library, index, options);
  clock.stage("hypotheses", out.hypotheses.size());
  return out;
}

std::vector<PoseHypothesis> search_rest(const std::vector<View>& views, const PoseSearch& search,
                                        const std::vector<PlacedModel>& known,
                                        const std::vector<Model>& library,
                                        const LibraryIndex& index,
                                        const HypothesisOptions& options) {
  std::vector<ViewLines> rest;
  for (std::size_t v = 0; v < views.size(); ++v) {
    rest.push_back(remaining_lines(search.lines[v], views[v].camera, known));
  }
  CrossingOptions crossing;
  crossing.one_view_ends = true;
  return find_hypotheses(rest, cross_edges(rest, crossing), library, index, options);
}

}  // namespace trihedron
