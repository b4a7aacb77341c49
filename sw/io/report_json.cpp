// SPDX-License-Identifier: Apache-2.0
#include "io/report_json.hpp"

#include <string>

namespace trihedron {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const std::vector<Model>& library, int id) {
  for (const Model& model : library)
    if (model.id == id) return model.name;
  return "";
}

Json to_json(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

Json to_json(const Transform& motion) {
  Json R = Json::array();
  for (int i = 0; i < 9; ++i) R.push_back(motion.R(i / 3, i % 3));
  return {{"R", R}, {"t_mm", to_json(motion.t)}};
}

Json to_json(const RecognizedObject& object, const std::vector<Model>& library) {
  Json out = {{"model_id", object.model_id},
              {"name", name_of(library, object.model_id)},
              {"score", object.score},
              {"world_from_model", to_json(object.world_from_model)},
              {"reprojection_rms_px", object.reprojection_rms_px}};
  Json covariance = Json::array();
  for (int i = 0; i < 36; ++i) covariance.push_back(object.covariance(i / 6, i % 6));
  out["covariance"] = covariance;
  out["runner_up"] = nullptr;
  if (object.runner_up_model_id >= 0)
    out["runner_up"] = {{"model_id", object.runner_up_model_id},
                        {"name", name_of(library, object.runner_up_model_id)},
                        {"score", object.runner_up_score}};
  out["surfaces"] = Json::array();
  for (const SurfaceMatch& match : object.surfaces)
    out["surfaces"].push_back({{"view", match.view},
                               {"scene_surface", match.scene_surface},
                               {"model_surface", match.model_surface},
                               {"visible_share", match.visible_share},
                               {"found_share", match.found_share}});
  return out;
}

Json to_json(const SceneSurface& surface) {
  Json vertices = Json::array();
  for (const Eigen::Vector3d& x : surface.vertices) vertices.push_back(to_json(x));
  return {{"view", surface.view},
          {"complete", surface.complete},
          {"area_mm2", surface.area},
          {"perimeter_mm", surface.perimeter},
          {"normal", to_json(surface.normal)},
          {"centroid_mm", to_json(surface.centroid)},
          {"vertices_mm", vertices}};
}

}  // namespace

Json report_json(const Scene& scene, const RecognitionResult& result,
                 const std::vector<Model>& library) {
  Json out = {{"scene", scene.name}};
  out["views"] = Json::array();
  for (std::size_t v = 0; v < scene.cameras.size(); ++v)
    out["views"].push_back({{"im_id", scene.im_ids[v]}, {"name", scene.cameras[v].view}});
  out["objects"] = Json::array();
  for (const RecognizedObject& object : result.objects)
    out["objects"].push_back(to_json(object, library));
  out["rejections"] = Json::array();
  for (const Rejection& rejection : result.rejections)
    out["rejections"].push_back({{"model_id", rejection.model_id},
                                 {"name", name_of(library, rejection.model_id)},
                                 {"score", rejection.score},
                                 {"reason", rejection.reason},
                                 {"world_from_model", to_json(rejection.world_from_model)}});
  out["surfaces"] = Json::array();
  for (const SceneSurface& surface : result.surfaces) out["surfaces"].push_back(to_json(surface));
  out["stages"] = Json::array();
  for (const StageStatistics& stage : result.stages)
    out["stages"].push_back(
        {{"stage", stage.stage}, {"count", stage.count}, {"seconds", stage.seconds}});
  return out;
}

}  // namespace trihedron
