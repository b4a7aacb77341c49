// SPDX-License-Identifier: Apache-2.0
// Which objects of a model library are in a scene, and where.
// usage: find_objects SCENE MODELS
#include <cstdio>

#include "golden/error.hpp"
#include "io/library.hpp"
#include "io/scene.hpp"
#include "io/views.hpp"
#include "recognition/recognize.hpp"

int main(int count, char** arguments) try {
  if (count != 3) {
    std::fprintf(stderr, "usage: find_objects SCENE MODELS\n");
    return 2;
  }
  const trihedron::Scene scene = trihedron::read_scene(arguments[1]);
  const auto library = trihedron::read_library(arguments[2]);
  const auto views = trihedron::make_views(scene, trihedron::golden_front_end());
  const trihedron::RecognitionResult result = trihedron::recognize(views, library);
  for (const trihedron::RecognizedObject& object : result.objects) {
    const Eigen::Vector3d& t = object.world_from_model.t;
    std::printf("model %d at (%.2f, %.2f, %.2f) mm, score %.3f\n", object.model_id, t.x(), t.y(),
                t.z(), object.score);
  }
  return result.objects.empty() ? 1 : 0;
} catch (const trihedron::Error& error) {
  std::fprintf(stderr, "find_objects: %s\n", error.what());
  return 2;
}
