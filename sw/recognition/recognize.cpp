// SPDX-License-Identifier: Apache-2.0
#include "recognition/recognize.hpp"

#include "golden/error.hpp"
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
