// SPDX-License-Identifier: Apache-2.0
#include "recognition/recognize.hpp"

#include <chrono>
#include <utility>

#include "golden/error.hpp"
#include "recognition/explanation.hpp"
#include "recognition/paper.hpp"
#include "recognition/pose_search.hpp"
#include "recognition/view_check.hpp"

namespace trihedron {
namespace {

RecognitionResult recognize_full(const std::vector<View>& views,
                                 const std::vector<Model>& library) {
  const LibraryIndex index(library);
  const PoseSearch search = search_poses(views, library, index);
  RecognitionResult result;
  result.stages = search.stages;
  const auto start = std::chrono::steady_clock::now();
  Explanation explanation = explain(views, library, search.hypotheses);
  result.objects = std::move(explanation.objects);
  result.rejections = std::move(explanation.rejections);
  result.surfaces = std::move(explanation.surfaces);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  result.stages.push_back({"poses", static_cast<int>(result.objects.size()), seconds.count()});
  return result;
}

}  // namespace

RecognitionResult recognize(const std::vector<View>& views, const std::vector<Model>& library,
                            const RecognitionOptions& options) {
  check_views(views);
  if (library.empty()) throw Error("the model library is empty: nothing can be recognised");
  if (options.method == Method::kPaper) return recognize_paper(views, library, options);
  return recognize_full(views, library);
}

}  // namespace trihedron
