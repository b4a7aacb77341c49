// SPDX-License-Identifier: Apache-2.0
#include "calibration/calibrate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "golden/error.hpp"
#include "io/scene_cameras.hpp"

namespace trihedron::cli {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

struct Arguments {
  std::vector<std::string> sources;
  std::string board, out;
  double square_mm = 0;
  CalibrateOptions options;
  bool json = false, quiet = false;
};

/// "12 of 13", "0.21", by camera and shot.
void print_shots(const std::vector<CameraShots>& cameras, const Calibration& calibration) {
  std::map<std::string, std::vector<std::string>> cells;
  std::vector<double> squares(cameras.size());
  std::vector<int> boards(cameras.size());
  for (std::size_t c = 0; c < cameras.size(); ++c)
    for (const Shot& shot : cameras[c].shots) {
      auto& row = cells[shot.key];
      row.resize(cameras.size(), "");
      row[c] = "none";
    }
  for (const ShotResidual& r : calibration.residuals) {
    const auto c = static_cast<std::size_t>(r.camera);
    cells[r.key][c] = fmt::format("{:.3f}", r.rms_px);
    squares[c] += r.rms_px * r.rms_px;
    ++boards[c];
  }
  fmt::print("{:<16}", "residual, px");
  for (const CameraShots& camera : cameras) fmt::print(" {:>12}", camera.name);
  for (const auto& [key, row] : cells) {
    fmt::print("\n{:<16}", key);
    for (const std::string& cell : row) fmt::print(" {:>12}", cell);
  }
  fmt::print("\n{:<16}", "all (rms)");
  for (std::size_t c = 0; c < cameras.size(); ++c)
    fmt::print(" {:>12.3f}", std::sqrt(squares[c] / boards[c]));
  fmt::print("\n{:<16}", "boards found");
  for (std::size_t c = 0; c < cameras.size(); ++c)
    fmt::print(" {:>12}", fmt::format("{} of {}", boards[c], cameras[c].shots.size()));
  fmt::print("\n\n");
}

void print_cameras(const Calibration& calibration) {
  fmt::print("{:<12} {:>19} {:>17}  {:>32} {:>9} {:>11}\n", "camera", "focal px +-", "principal px",
             "position in world, mm", "+- mm", "+- mrad");
  for (std::size_t c = 0; c < calibration.cameras.size(); ++c) {
    const Camera& camera = calibration.cameras[c];
    const CameraUncertainty& sd = calibration.uncertainty[c];
    const Eigen::Vector3d at = camera.camera_from_world.inverse().t;
    fmt::print(
        "{:<12} {:>12.2f} {:>6.2f} {:>8.1f} {:>8.1f}  {:>10.2f} {:>10.2f} {:>10.2f} {:>9.3f} "
        "{:>11.3f}\n",
        camera.view, std::sqrt(camera.K(0, 0) * camera.K(1, 1)), sd.focal_px, camera.K(0, 2),
        camera.K(1, 2), at.x(), at.y(), at.z(), sd.position_mm, 1e3 * sd.rotation_rad);
  }
  fmt::print("(positions and turns +- one standard deviation, seen from the first camera)\n");
}

void print_json(const Calibration& calibration) {
  nlohmann::ordered_json out;
  out["rms_px"] = calibration.rms_px;
  out["cameras"] = nlohmann::ordered_json::array();
  for (std::size_t c = 0; c < calibration.cameras.size(); ++c) {
    nlohmann::ordered_json entry = camera_json(calibration.cameras[c]);
    entry["focal_sd_px"] = calibration.uncertainty[c].focal_px;
    entry["position_sd_mm"] = calibration.uncertainty[c].position_mm;
    entry["rotation_sd_deg"] = calibration.uncertainty[c].rotation_rad * kDegrees;
    entry["shots"] = nlohmann::ordered_json::object();
    for (const ShotResidual& r : calibration.residuals)
      if (r.camera == static_cast<int>(c)) entry["shots"][r.key] = r.rms_px;
    out["cameras"].push_back(entry);
  }
  fmt::print("{}\n", out.dump(1));
}

int run(const Arguments& arguments) {
  const Board board = parse_board(arguments.board, arguments.square_mm);
  std::vector<CameraShots> cameras;
  {
    Progress progress(arguments.sources.size(), "cameras", arguments.quiet);
    for (const std::string& source : arguments.sources) {
      cameras.push_back(read_shots(source, board));
      progress.step();
    }
  }
  const Calibration calibration = calibrate(cameras, board, arguments.options);
  if (!arguments.out.empty()) write_cameras(arguments.out, calibration.cameras);
  if (arguments.json) {
    print_json(calibration);
  } else if (!arguments.quiet) {
    print_shots(cameras, calibration);
    print_cameras(calibration);
    if (!arguments.out.empty()) fmt::print("written: {}\n", arguments.out);
  }
  return kDone;
}

void add_options(CLI::App& command, Arguments& arguments) {
  command
      .add_option("CAMERA", arguments.sources,
                  "Per camera a folder of images, or a quoted pattern such as 'left*.jpg'; images "
                  "of one name (one * part) were taken together")
      ->required();
  command
      .add_option("--board", arguments.board, "Inner corners of the chessboard, one number even")
      ->type_name("9x6")
      ->required();
  command.add_option("--square", arguments.square_mm, "Side of a square, mm")
      ->type_name("MM")
      ->required()
      ->check(kPositive);
  command.add_option("--out", arguments.out, "Write the cameras, in the order given")
      ->type_name("scene_camera.json");
  command
      .add_option("--table", arguments.options.table_shot,
                  "Shot with the board flat on the table: the world's z = 0 (otherwise the world "
                  "is the first camera's frame)")
      ->type_name("SHOT");
  command
      .add_option("--thickness", arguments.options.board_thickness_mm,
                  "With --table: how far the table lies below the printed face, mm")
      ->type_name("MM")
      ->check(kNotNegative);
  command
      .add_option("--lens-terms", arguments.options.lens_terms,
                  "How many of k1 k2 p1 p2 k3 are estimated: 0, 1, 2, 4 or 5 (wide lenses)")
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace

void add_calibrate(CLI::App& program, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "calibrate", "Cameras of a rig from pictures of a chessboard, to scene_camera.json");
  add_options(*command, *arguments);
  command->add_flag("--json", arguments->json, "Print the result as JSON");
  command->add_flag("--quiet", arguments->quiet, "Print nothing");
  command->footer(
      "Examples:\n"
      "  trihedron calibrate shots/top shots/side shots/front --board 9x6 --square 20 \\\n"
      "    --table 000 --out scene_camera.json\n"
      "  trihedron calibrate 'left*.jpg' 'right*.jpg' --board 9x6 --square 25 --lens-terms 5\n"
      "\n"
      "Sets that cannot determine the cameras are refused with what is missing (exit code 2).");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace trihedron::cli
