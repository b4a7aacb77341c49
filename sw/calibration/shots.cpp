// SPDX-License-Identifier: Apache-2.0
#include "calibration/shots.hpp"

#include <fmt/format.h>

#include "golden/error.hpp"
#include "io/file.hpp"
#include "io/frame_stream.hpp"
#include "io/image.hpp"

namespace trihedron {
namespace {

namespace fs = std::filesystem;

/// A name without the separators that stand between it and a number: "left_" is "left".
std::string trimmed(std::string name) {
  const std::size_t last = name.find_last_not_of("-_. ");
  return last == std::string::npos ? name : name.substr(0, last + 1);
}

void list_folder(const fs::path& folder, CameraShots& camera) {
  camera.name = fs::weakly_canonical(folder).filename().string();
  for (const fs::path& file : images_of(folder))
    camera.shots.push_back({file.stem().string(), file, {}});
}

void list_pattern(const fs::path& pattern, CameraShots& camera) {
  const std::string name = pattern.filename().string();
  const std::string before = name.substr(0, name.find('*')), after = name.substr(before.size() + 1);
  const fs::path folder = pattern.parent_path().empty() ? "." : pattern.parent_path();
  require_folder(folder, "the folder of " + name);
  camera.name = trimmed(before.empty() ? pattern.parent_path().filename().string() : before);
  for (const fs::path& file : images_of(folder)) {
    const std::string text = file.filename().string();
    if (text.size() <= before.size() + after.size()) continue;  // * is not nothing
    if (text.compare(0, before.size(), before) != 0) continue;
    if (text.compare(text.size() - after.size(), after.size(), after) != 0) continue;
    camera.shots.push_back(
        {text.substr(before.size(), text.size() - before.size() - after.size()), file, {}});
  }
}

}  // namespace

CameraShots read_shots(const std::string& source, const Board& board) {
  CameraShots camera;
  if (fs::path(source).filename().string().find('*') != std::string::npos) {
    list_pattern(source, camera);
  } else {
    require_folder(source, "a folder of images of the board, or a pattern such as 'left*.jpg'");
    list_folder(source, camera);
  }
  if (camera.shots.empty())
    throw Error(source + ": no image; expected images of the board (PNG, JPEG, TIFF, BMP or PGM)");
  for (Shot& shot : camera.shots) {
    const cv::Mat image = read_grey(shot.file);
    if (camera.size.empty()) camera.size = image.size();
    if (image.size() != camera.size)
      throw Error(fmt::format("{}: the image is {} x {} px; expected {} x {} px as in {}",
                              shot.file.string(), image.cols, image.rows, camera.size.width,
                              camera.size.height, camera.shots.front().file.string()));
    shot.corners = find_board(image, board);
  }
  return camera;
}

}  // namespace trihedron
