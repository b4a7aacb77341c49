// SPDX-License-Identifier: Apache-2.0
#include "recognition/recognize.hpp"

#include <chrono>
#include <utility>

#include "golden/error.hpp"
#include "recognition/explanation.hpp"
#include "recognition/paper.hpp"
#include "recognition/pose_search.hpp"
#include "recognition/recognizer.hpp"
#include "recognition/view_check.hpp"

namespace trihedron {

Recognizer::Recognizer(const std::vector<Model>& library)
    : library_(library), index_(library), facts_(library) {
  if (library.empty()) throw Error("the model library is empty: nothing can be recognised");
}

RecognitionResult Recognizer::recognize(const std::vector<View>& views,
                                        const RecognitionOptions& options) const {
  check_views(views);
  if (options.method == Method::kPaper) return recognize_paper(views, library_, options);
  return recognize_full(views);
}

RecognitionResult Recognizer::recognize_full(const std::vector<View>& views) const {
  const PoseSearch search = search_poses(views, library_, index_);
  RecognitionResult result;
  result.stages = search.stages;
  const auto start = std::chrono::steady_clock::now();
  const auto more = [&](const std::vector<PlacedModel>& known) {
    return search_rest(views, search, known, library_, index_);
  };
  Explanation explanation =
      explain(views, search.edgels, library_, facts_, search.hypotheses, more);
  result.objects = std::move(explanation.objects);
  result.rejections = std::move(explanation.rejections);
  result.surfaces = std::move(explanation.surfaces);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  result.stages.push_back({"poses", static_cast<int>(result.objects.size()), seconds.count()});
  return result;
}

RecognitionResult recognize(const std::vector<View>& views, const std::vector<Model>& library,
                            const RecognitionOptions& options) {
  return Recognizer(library).recognize(views, options);
}

}  // namespace trihedron
