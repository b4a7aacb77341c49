// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "golden/error.hpp"
#include "io/library.hpp"
#include "render/generate.hpp"
#include "render/variants.hpp"

namespace trihedron::cli {
namespace {

struct RenderArguments {
  std::filesystem::path out, models, camera_file, pose_file, write_models;
  std::string variant = "none";
  std::uint64_t seed = 1;
  int scenes = 1, first_id = 1;
  bool json = false, quiet = false;
  std::vector<double> distortion;
  double jitter = -1;  // below 0: as the look has it
  double noise = -1, blur_px = -1, grain = -1, vignetting = -1;
  std::string shadows = "look";
  render::GenerateOptions options;
};

void set_if_given(std::optional<double>& option, double value) {
  if (value >= 0) option = value;
}

void complete(RenderArguments& a) {
  render::RigOptions& rig = a.options.rig;
  // The cad look is the source method's world: orthographic cameras in their nominal places.
  rig.orthographic = rig.orthographic || a.options.look == "cad";
  rig.jitter = a.jitter >= 0 ? a.jitter : (a.options.look == "cad" ? 0 : 1);
  std::copy(a.distortion.begin(), a.distortion.end(), rig.distortion.begin());
  set_if_given(a.options.noise, a.noise);
  set_if_given(a.options.blur_px, a.blur_px);
  set_if_given(a.options.grain, a.grain);
  set_if_given(a.options.vignetting, a.vignetting);
  if (a.shadows != "look") a.options.shadows = a.shadows == "on";
  if (!a.camera_file.empty()) a.options.cameras = render::read_cameras(a.camera_file);
  if (!a.pose_file.empty() && a.camera_file.empty())
    throw Error("render: --poses is given in a camera's frame; give its --camera-file as well");
}

void run(RenderArguments a) {
  complete(a);
  render::Random variants(a.seed, ~std::uint64_t{0});
  const std::vector<Model> library =
      render::make_variants(read_library(a.models), render::variant_of(a.variant), variants);
  if (!a.write_models.empty()) render::write_library(a.write_models, library);
  Progress progress(static_cast<std::size_t>(a.scenes), "scenes", a.quiet);
  for (int i = 0; i < a.scenes; ++i) {
    const std::filesystem::path folder = a.out / fmt::format("{:06}", a.first_id + i);
    const render::RenderedScene scene =
        a.pose_file.empty()
            ? render::generate_scene(library, a.options, a.seed, i)
            : render::generate_scene(render::read_objects(a.pose_file, a.options.cameras, library),
                                     a.options, a.seed, i);
    render::write_scene(folder, scene);
    progress.step();
  }
  progress.clear();
  if (a.json)
    fmt::print("{}\n", nlohmann::json{{"scenes", a.scenes}, {"folder", a.out.string()}}.dump());
  else if (!a.quiet)
    fmt::print("{} scenes in {}\n", a.scenes, a.out.string());
}

void add_scene_options(CLI::App& command, RenderArguments& a) {
  render::GenerateOptions& o = a.options;
  command.add_option("--scenes", a.scenes, "number of scenes")->check(kPositive);
  command.add_option("--first-id", a.first_id, "number of the first scene's folder");
  command.add_option("--seed", a.seed, "same seed, same scenes")->check(kNotNegative);
  command.add_option("--objects", o.placement.objects, "objects per scene")->check(kPositive);
  command.add_flag("--stacked", o.placement.stacked, "the second object stands on the first");
  command.add_flag("--leaning", o.placement.leaning, "one object leans against the first");
  command.add_flag("--repeat", o.placement.repeat_models, "a model may occur more than once");
  command.add_option("--gap", o.placement.gap_mm, "least distance of objects in plan, mm");
  command.add_option("--variant", a.variant,
                     "objects that are not in the library: none, scaled (10 % along one axis), "
                     "mirrored, both");
  command.add_option("--poses", a.pose_file, "scene_gt.json with the objects' poses");
  command.add_flag("--json", a.json, "print the result as JSON");
  command.add_flag("--quiet", a.quiet, "print nothing");
  command.add_option("--write-models", a.write_models, "folder for the models as rendered");
}

void add_picture_options(CLI::App& command, RenderArguments& a) {
  render::GenerateOptions& o = a.options;
  command.add_option("--look", o.look, "cad, studio or lab");
  command.add_option("--noise", a.noise, "pixel noise, standard deviation, grey levels");
  command.add_option("--blur", a.blur_px, "point spread, standard deviation, px");
  command.add_option("--grain", a.grain, "blotchy noise, standard deviation, grey levels");
  command.add_option("--vignetting", a.vignetting, "loss of light in the corners, fraction");
  command.add_option("--contrast", o.contrast, "factor of all grey-level differences")
      ->check(kPositive);
  command.add_option("--shadows", a.shadows, "on, off, or as the look has them")
      ->check(CLI::IsMember({"look", "on", "off"}));
  command.add_option("--threads", o.threads, "0: all; the pictures do not depend on it");
}

void add_camera_options(CLI::App& command, RenderArguments& a) {
  render::GenerateOptions& o = a.options;
  command.add_option("--rig", o.rig.name, "paper (450 x 300 px) or hd (1280 x 960 px)");
  command.add_option("--cameras", o.rig.cameras, "top, side, front, then oblique ones; 2 or more");
  command.add_option("--camera-file", a.camera_file, "scene_camera.json, instead of a rig");
  command.add_flag("--orthographic", o.rig.orthographic, "parallel projection (always with cad)");
  command.add_option("--distortion", a.distortion, "lens distortion k1 k2 p1 p2 k3 as in OpenCV")
      ->expected(1, 5);
  command.add_option("--jitter", a.jitter,
                     "cameras off their nominal poses: 1 is 12 mm and 1 degree (0 with cad)");
  command
      .add_option("--calibration-error", o.calibration_error_px,
                  "error of the written cameras, standard deviation in the image, px")
      ->check(kNotNegative);
}

}  // namespace

void add_render(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command =
      program.add_subcommand("render", "Views of scenes made from models and poses, with truth");
  command->add_option("OUT", arguments->out, "data set folder to write")->required();
  command->add_option("--models", arguments->models, "model library")->required();
  add_scene_options(*command, *arguments);
  add_picture_options(*command, *arguments);
  add_camera_options(*command, *arguments);
  command->footer(
      "Example:\n  trihedron render scenes --models testvectors/models10 --look lab --objects 2 "
      "--stacked --scenes 20");
  command->callback([arguments, &exit_code] {
    run(*arguments);
    exit_code = kDone;
  });
}

}  // namespace trihedron::cli
