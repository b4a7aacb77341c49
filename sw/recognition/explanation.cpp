// SPDX-License-Identifier: Apache-2.0
#include "recognition/explanation.hpp"

#include <algorithm>

#include "recognition/seen_surfaces.hpp"

namespace trihedron {
namespace {

RecognizedObject report(const SceneInput& input, const SceneSearch& search, int i,
                        std::vector<SceneSurface>& surfaces) {
  const Candidate& candidate = search.candidates()[i];
  RecognizedObject out;
  out.model_id = input.library[candidate.model].id;
  out.world_from_model = candidate.pose.world_from_model;
  out.covariance = candidate.pose.covariance;
  out.score = candidate.verdict.found_share;
  out.reprojection_rms_px = candidate.pose.rms_px;
  const int rival = search.runner_up(i);
  if (rival >= 0) {
    out.runner_up_model_id = input.library[search.candidates()[rival].model].id;
    out.runner_up_score = search.candidates()[rival].verdict.found_share;
  }
  int position = 0;
  const auto context = search.context_of(i, position);
  describe_surfaces(input.views, context, position,
                    collect_evidence(input.views, context, position, true), surfaces, out.surfaces);
  return out;
}

Rejection report_rejection(const SceneInput& input, const Candidate& candidate) {
  const std::string& reason = candidate.verdict.reason;
  return {input.library[candidate.model].id, candidate.pose.world_from_model,
          candidate.verdict.found_share,
          reason.empty() ? "a better answer stands in its place" : reason};
}

}  // namespace

Explanation explain(const std::vector<View>& views, const std::vector<Model>& library,
                    const std::vector<PoseHypothesis>& hypotheses,
                    const ExplanationOptions& options) {
  std::vector<EdgelMap> edgels;
  for (const View& view : views) edgels.push_back(find_edgels(view.features));
  return explain(views, edgels, library, ModelFacts(library), hypotheses, {}, options);
}

Explanation explain(const std::vector<View>& views, const std::vector<EdgelMap>& edgels,
                    const std::vector<Model>& library, const ModelFacts& facts,
                    const std::vector<PoseHypothesis>& hypotheses, const MoreHypotheses& more,
                    const ExplanationOptions& options) {
  std::vector<ContourField> fields;
  fields.reserve(views.size());
  SceneInput input{{}, {}, library, facts, hypotheses, more};
  for (std::size_t v = 0; v < views.size(); ++v) {
    fields.emplace_back(views[v].features, edgels[v]);
    input.views.push_back({&views[v].camera, &fields.back()});
    input.maps.push_back(spread_map(fields.back()));
  }
  SceneSearch search(input, options.search);
  search.run();

  Explanation out;
  const std::vector<int> objects = search.objects();
  for (int i : objects) out.objects.push_back(report(input, search, i, out.surfaces));
  std::stable_sort(
      out.objects.begin(), out.objects.end(),
      [](const RecognizedObject& a, const RecognizedObject& b) { return a.score > b.score; });
  for (int i = 0; i < static_cast<int>(search.candidates().size()); ++i) {
    if (std::count(objects.begin(), objects.end(), i)) continue;
    out.rejections.push_back(report_rejection(input, search.candidates()[i]));
  }
  return out;
}

}  // namespace trihedron
