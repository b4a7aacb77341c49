// SPDX-License-Identifier: Apache-2.0
#include "report/scene_data.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "io/report_json.hpp"
#include "report/data_uri.hpp"
#include "report/drawn_layers.hpp"
#include "report/picture_layers.hpp"
#include "report/space.hpp"

namespace trihedron::report {
namespace {

// BGR, from the palette of Okabe and Ito, which colour-blind people can tell apart. The page's
// style sheet uses the same two in its legend.
const cv::Vec3b kFirstContourColour{233, 180, 86};  // sky blue
const cv::Vec3b kContourColour{0, 159, 230};        // orange

const Model* find_model(const std::vector<Model>& library, int id) {
  const auto at = std::find_if(library.begin(), library.end(),
                               [id](const Model& model) { return model.id == id; });
  return at == library.end() ? nullptr : &*at;
}

std::vector<PlacedModel> placed_objects(const RecognizedScene& input) {
  std::vector<PlacedModel> placed;
  for (const RecognizedObject& object : input.result.objects)
    if (const Model* model = find_model(input.library, object.model_id))
      placed.push_back({model, object.world_from_model});
  return placed;
}

Json object_layers(const View& view, const ContourField& field,
                   const std::vector<PlacedModel>& placed) {
  Json list = Json::array();
  for (int i = 0; i < static_cast<int>(placed.size()); ++i) {
    const PlacedModel& object = placed[static_cast<std::size_t>(i)];
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& x : object.model->mesh.vertices)
      centre += x / static_cast<double>(object.model->mesh.vertices.size());
    list.push_back({{"label", numbers(view.camera.project(object.world_from_model * centre))},
                    {"edges", edge_layer(view.camera, placed, i)},
                    {"residuals", residual_layer({&view.camera, &field}, placed, i)}});
  }
  return list;
}

int count(const ViewFeatures& features, ContourFlag flag) {
  return static_cast<int>(
      std::count_if(features.contour.begin(), features.contour.end(),
                    [flag](const ContourBeat& beat) { return (beat.flags & flag) != 0; }));
}

/// What one view shows, from the picture to the residuals.
void add_layers(Json& out, const RecognizedScene& input, std::size_t index,
                const std::vector<PlacedModel>& placed, const ViewLines& lines) {
  const View& view = input.views[index];
  const ViewFeatures& features = view.features;
  out["width"] = features.width;
  out["height"] = features.height;
  out["first_contour_px"] = count(features, kFirstContour);
  out["contour_px"] = count(features, kContour);
  out["vertices_lost"] = features.vertices_lost;
  out["pictures"] = {
      {"image", png_data_uri(input.scene.images[index])},
      {"gradient", png_data_uri(gradient_picture(features))},
      {"first_contour",
       png_data_uri(contour_picture(features, kFirstContour, kFirstContourColour))},
      {"second_contour", png_data_uri(contour_picture(features, kContour, kContourColour))}};
  out["vertices"] = vertex_layer(features);
  out["regions"] = region_layer(features);
  out["segments"] = segment_layer(lines, view.camera);
  const ContourField field(features);
  out["objects"] = object_layers(view, field, placed);
}

Json rejected_edges(const RecognizedScene& input, const Rejection& rejection) {
  Json views = Json::array();
  const Model* model = find_model(input.library, rejection.model_id);
  for (const View& view : input.views)
    views.push_back(model == nullptr
                        ? Json::array()
                        : edge_layer(view.camera, {{model, rejection.world_from_model}}, 0));
  return views;
}

Json space(const RecognizedScene& input, const std::vector<PlacedModel>& placed,
           const std::vector<ViewLines>& lines) {
  const Eigen::Vector3d focus = looked_at(input.scene.cameras);
  Json cameras = Json::array(), models = Json::array(), truth = Json::array();
  for (const Camera& camera : input.scene.cameras) cameras.push_back(space_camera(camera, focus));
  for (const PlacedModel& object : placed) models.push_back(space_model(object));
  if (input.scene.truth)
    for (const TrueObject& object : *input.scene.truth)
      if (const Model* model = find_model(input.library, object.model_id))
        truth.push_back(space_model({model, object.world_from_model}));
  return {{"focus", numbers(focus)},
          {"cameras", cameras},
          {"models", models},
          {"truth", truth},
          {"edges", space_edges(cross_edges(lines))}};
}

Json hardware(const HardwareActivity& activity) {
  Json views = Json::array();
  for (const ViewActivity& view : activity.views)
    views.push_back({{"pixels", view.pixels},
                     {"input_stalls", view.input_stalls},
                     {"input_idles", view.input_idles},
                     {"contour_beats", view.contour_beats},
                     {"contour_stalls", view.contour_stalls},
                     {"latency_clocks", view.latency_clocks},
                     {"vertices", view.vertices},
                     {"vertices_lost", view.vertices_lost},
                     {"stream_errors", view.stream_errors}});
  return {{"clocks", activity.clocks}, {"views", views}};
}

/// Per true object what became of it, null without truth.
Json truth(const RecognizedScene& input) {
  if (!input.scene.truth) return nullptr;
  const SceneScore score = score_scene(input.result, *input.scene.truth, input.library);
  Json objects = Json::array();
  for (std::size_t i = 0; i < score.objects.size(); ++i) {
    const int id = (*input.scene.truth)[i].model_id;
    const Model* model = find_model(input.library, id);
    objects.push_back({{"model_id", id},
                       {"name", model == nullptr ? "(not in the library)" : model->name},
                       {"known", model != nullptr},
                       {"right", score.objects[i].right},
                       {"vertex_mm", score.objects[i].vertex_mm}});
  }
  return {{"objects", objects}, {"wrong", score.wrong}};
}

/// Mean distance in mm of an object's vertices from the nearest true object of its model.
Json truth_error(const RecognizedScene& input, const RecognizedObject& object) {
  const Model* model = find_model(input.library, object.model_id);
  if (!input.scene.truth || model == nullptr) return nullptr;
  Json nearest;
  for (const TrueObject& other : *input.scene.truth) {
    if (other.model_id != object.model_id) continue;
    const double error =
        pose_error(*model, object.world_from_model, other.world_from_model).mean_mm;
    if (nearest.is_null() || error < nearest.get<double>()) nearest = error;
  }
  return nearest;
}

/// The first view in small and the edges of the models in it, in px of the whole picture.
Json thumbnail(const RecognizedScene& input) {
  constexpr int kWidthPx = 168, kStepMask = 0xf8;  // 32 tones pack better
  const cv::Mat& whole = input.scene.images[0];
  cv::Mat small;
  cv::resize(whole, small, {kWidthPx, whole.rows * kWidthPx / whole.cols}, 0, 0, cv::INTER_AREA);
  const std::vector<PlacedModel> placed = placed_objects(input);
  Json objects = Json::array();
  for (int i = 0; i < static_cast<int>(placed.size()); ++i)
    objects.push_back(edge_layer(input.views[0].camera, placed, i));
  return {{"width", whole.cols},
          {"height", whole.rows},
          {"picture", png_data_uri(small & kStepMask)},
          {"objects", objects}};
}

}  // namespace

bool failed(const RecognizedScene& input) {
  const Json held = truth(input);
  if (held.is_null()) return input.result.objects.empty();
  const Json& objects = held.at("objects");
  return held.at("wrong") != 0 || std::any_of(objects.begin(), objects.end(), [](const Json& o) {
           return o.at("known") == true && o.at("right") == false;
         });
}

Json scene_line(const RecognizedScene& input) {
  Json found = Json::array();
  for (const RecognizedObject& object : input.result.objects) {
    const Model* model = find_model(input.library, object.model_id);
    found.push_back(model == nullptr ? "" : model->name);
  }
  double seconds = 0;
  for (const StageStatistics& stage : input.result.stages) seconds += stage.seconds;
  return {{"scene", input.scene.name},
          {"kind", input.scene.kind},
          {"found", found},
          {"truth", truth(input)},
          {"milliseconds", 1e3 * seconds},
          {"thumbnail", thumbnail(input)}};
}

Json scene_data(const RecognizedScene& input) {
  Json out = report_json(input.scene, input.result, input.library);
  const std::vector<PlacedModel> placed = placed_objects(input);
  std::vector<ViewLines> lines;
  for (const View& view : input.views) lines.push_back(find_lines(view));
  for (std::size_t v = 0; v < input.views.size(); ++v)
    add_layers(out["views"][v], input, v, placed, lines[v]);
  for (std::size_t i = 0; i < input.result.objects.size(); ++i)
    out["objects"][i]["truth_error_mm"] = truth_error(input, input.result.objects[i]);
  for (std::size_t i = 0; i < input.result.rejections.size(); ++i)
    out["rejections"][i]["views"] = rejected_edges(input, input.result.rejections[i]);
  out["kind"] = input.scene.kind;
  out["front_end"] = input.front_end;
  out["method"] = input.method;
  out["library"] = input.library.size();
  out["truth"] = truth(input);
  out["space"] = space(input, placed, lines);
  out["hardware"] = input.hardware.views.empty() ? Json() : hardware(input.hardware);
  return out;
}

}  // namespace trihedron::report
