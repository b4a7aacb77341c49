// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recognition/index.hpp"
#include "recognition/model_facts.hpp"
#include "recognition/recognize.hpp"

namespace trihedron {

/// A library made ready once for any number of scenes: its corners and edges sorted for look-up,
/// what else is known of a model kept when first asked for. Threads may share it; what it answers
/// does not depend on what it was asked before.
class Recognizer {
 public:
  /// `library` outlives the recognizer. Throws Error when it is empty.
  explicit Recognizer(const std::vector<Model>& library);

  /// As the function recognize(), without its work on the library.
  RecognitionResult recognize(const std::vector<View>& views,
                              const RecognitionOptions& options = {}) const;

  const std::vector<Model>& library() const { return library_; }

 private:
  RecognitionResult recognize_full(const std::vector<View>& views) const;

  const std::vector<Model>& library_;
  LibraryIndex index_;
  ModelFacts facts_;
};

}  // namespace trihedron
