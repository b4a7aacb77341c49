// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "io/scene_cameras.hpp"
#include "recognition/rig_accuracy.hpp"

namespace trihedron::cli {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

struct Arguments {
  std::string cameras;
  double noise_px = 0.2, side_mm = 100;
  std::vector<double> centre;
  bool json = false, quiet = false;
};

/// A point of the working volume, and what the rig makes of it.
struct Place {
  Eigen::Vector3d at;
  PointAccuracy accuracy;
};

std::vector<Camera> cameras_of(const std::string& file) {
  std::vector<Camera> out;
  for (const ViewCamera& view : read_cameras(file)) {
    out.push_back(view.camera);
    Camera& camera = out.back();
    // Files without a size: the principal point is taken for the middle.
    if (camera.width_px == 0) camera.width_px = static_cast<int>(2 * camera.K(0, 2)) + 1;
    if (camera.height_px == 0) camera.height_px = static_cast<int>(2 * camera.K(1, 2)) + 1;
  }
  return out;
}

/// The middle of the working cube and its eight corners.
std::vector<Place> places(const std::vector<Camera>& cameras, const Eigen::Vector3d& centre,
                          const Arguments& arguments) {
  std::vector<Place> out{{centre, {}}};
  for (int corner = 0; corner < 8; ++corner)
    out.push_back({centre + arguments.side_mm / 2 *
                                Eigen::Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                                corner & 4 ? 1 : -1),
                   {}});
  for (Place& place : out) place.accuracy = point_accuracy(cameras, place.at, arguments.noise_px);
  return out;
}

void print(const std::vector<Camera>& cameras, const std::vector<Place>& all, double noise_px) {
  const Eigen::Vector3d& centre = all.front().at;
  fmt::print("{:<12} {:>12} {:>12} {:>14}\n", "camera", "image px", "mm per px", "distance mm");
  for (const Camera& camera : cameras)
    fmt::print("{:<12} {:>12} {:>12.4f} {:>14.1f}\n", camera.view,
               fmt::format("{}x{}", camera.width_px, camera.height_px),
               1 / camera.px_per_mm_at(centre), (camera.camera_from_world * centre).z());
  fmt::print("\nwidest angle between lines of sight: {:.1f} degrees (90 is best)\n\n",
             widest_angle(cameras, centre) * kDegrees);
  fmt::print(
      "one point measured with errors of {:g} px in every view that has it, standard "
      "deviations:\n{:<30} {:>6} {:>9} {:>9}   {}\n",
      noise_px, "point, world, mm", "views", "best mm", "worst mm", "worst along");
  for (const Place& place : all) {
    const PointAccuracy& a = place.accuracy;
    const std::string at =
        fmt::format("({:8.1f} {:8.1f} {:8.1f})", place.at.x(), place.at.y(), place.at.z());
    if (a.views < 2)
      fmt::print("{:<30} {:>6} {:>9} {:>9}   seen by fewer than two cameras\n", at, a.views, "-",
                 "-");
    else
      fmt::print("{:<30} {:>6} {:>9.4f} {:>9.4f}   ({:5.2f} {:5.2f} {:5.2f})\n", at, a.views,
                 a.best_mm, a.worst_mm, a.worst_axis.x(), a.worst_axis.y(), a.worst_axis.z());
  }
}

void print_json(const std::vector<Camera>& cameras, const std::vector<Place>& all) {
  nlohmann::ordered_json out;
  out["widest_angle_deg"] = widest_angle(cameras, all.front().at) * kDegrees;
  for (const Camera& camera : cameras)
    out["mm_per_px"][camera.view] = 1 / camera.px_per_mm_at(all.front().at);
  for (const Place& place : all)
    out["points"].push_back({{"world_mm", {place.at.x(), place.at.y(), place.at.z()}},
                             {"views", place.accuracy.views},
                             {"best_mm", place.accuracy.best_mm},
                             {"worst_mm", place.accuracy.worst_mm}});
  fmt::print("{}\n", out.dump(1));
}

int run(const Arguments& arguments) {
  const std::vector<Camera> cameras = cameras_of(arguments.cameras);
  const Eigen::Vector3d centre =
      arguments.centre.empty()
          ? rig_centre(cameras)
          : Eigen::Vector3d(arguments.centre[0], arguments.centre[1], arguments.centre[2]);
  const std::vector<Place> all = places(cameras, centre, arguments);
  if (arguments.json)
    print_json(cameras, all);
  else if (!arguments.quiet)
    print(cameras, all, arguments.noise_px);
  return all.front().accuracy.views < 2 ? kNothingFound : kDone;
}

}  // namespace

void add_rig(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("rig", "What accuracy a set of cameras allows, point by point");
  command->add_option("CAMERAS", arguments->cameras, "The cameras' scene_camera.json")->required();
  command
      ->add_option("--noise", arguments->noise_px,
                   "Error of an image position, standard deviation, px")
      ->type_name("PX")
      ->check(kPositive)
      ->capture_default_str();
  command
      ->add_option("--centre", arguments->centre,
                   "Middle of the working volume, world, mm; "
                   "otherwise where the optical axes meet")
      ->type_name("X Y Z")
      ->expected(3);
  command->add_option("--side", arguments->side_mm, "Side of the working volume, a cube, mm")
      ->type_name("MM")
      ->check(kPositive)
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print the figures as JSON");
  command->add_flag("--quiet", arguments->quiet, "Print nothing; the exit code tells");
  command->footer(
      "Example:\n"
      "  trihedron rig testvectors/scenes/studio-two/000034/scene_camera.json --noise 0.2\n"
      "\n"
      "Exit code 1: fewer than two cameras see the middle.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace trihedron::cli
