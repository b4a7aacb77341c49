// SPDX-License-Identifier: Apache-2.0
// Any bytes as one of a scene's JSON files, or as one of its images; the others are good.
#include <opencv2/imgcodecs.hpp>

#include "fuzz/harness.hpp"
#include "io/file.hpp"
#include "io/scene.hpp"
#include "scratch.hpp"

namespace {

using namespace trihedron;

constexpr const char* kFiles[] = {"scene_camera.json", "scene_gt.json", "scene_kind.json",
                                  "gray/000000.png"};

/// A scene of two small views.
class SceneFolder {
 public:
  SceneFolder() {
    const std::string camera =
        R"("cam_K":[90,0,32,0,90,24,0,0,1],"cam_R_w2c":[1,0,0,0,-1,0,0,0,-1],"cam_t_w2c":[0,0,600])";
    good_[0] = "{\"0\":{" + camera + "},\"1\":{" + camera + "}}";
    good_[1] = R"({"0":[{"obj_id":1,"cam_R_m2c":[1,0,0,0,1,0,0,0,1],"cam_t_m2c":[0,0,600]}]})";
    good_[2] = R"({"look":"lab","rig":"paper","objects":1,"stacked":0})";
    std::vector<unsigned char> png;
    cv::imencode(".png", cv::Mat(48, 64, CV_8U, cv::Scalar(90)), png);
    good_[3].assign(png.begin(), png.end());
    for (int i = 0; i < 4; ++i) scratch_.write(kFiles[i], good_[i]);
    scratch_.write("gray/000001.png", good_[3]);
  }

  void read_with(unsigned which, const std::string& bytes) const {
    scratch_.write(kFiles[which], bytes);
    fuzz::take_or_refuse([&] { read_scene(scratch_.path()); });
    scratch_.write(kFiles[which], good_[which]);
  }

 private:
  Scratch scratch_;
  std::string good_[4];
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const SceneFolder folder;
  folder.read_with(fuzz::kind_of(data, size, 4), fuzz::rest_of(data, size));
  return 0;
}
