// SPDX-License-Identifier: Apache-2.0
#include "render/view.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <thread>

#include "golden/error.hpp"
#include "render/random.hpp"
#include "render/ray_caster.hpp"
#include "render/shading.hpp"

namespace trihedron::render {
namespace {

void check(const World& world, const Camera& camera) {
  if (camera.width_px <= 0 || camera.height_px <= 0)
    throw Error("render: camera " + camera.view +
                " has no image size; give width and height in px");
  std::size_t surfaces = 0;
  for (const PlacedObject& object : world.objects) surfaces += object.model->surfaces.size();
  if (surfaces > std::numeric_limits<std::uint16_t>::max())
    throw Error("render: the scene has " + std::to_string(surfaces) +
                " surfaces; the truth image can name 65535");
}

// Renders rows of pixels; one per thread.
class RowRenderer {
 public:
  RowRenderer(const World& world, const Camera& camera, const ViewCaster& caster,
              const Shader& shader, std::uint64_t seed)
      : camera_(camera),
        caster_(caster),
        shader_(shader),
        seed_(seed),
        orthographic_(camera.projection == Camera::Projection::kOrthographic),
        world_from_camera_(camera.camera_from_world.inverse()),
        visible(world.objects.size(), 0),
        alone(world.objects.size(), 0),
        samples_(kSubsamples * kSubsamples) {
    for (std::size_t o = 0; o < world.objects.size(); ++o)
      object_of_.insert(object_of_.end(), world.objects[o].model->surfaces.size(), o);
  }

  void row(int y, cv::Mat& ideal, cv::Mat& surfaces) {
    for (int j = 0; j < kSubsamples; ++j) {
      caster_.cast(y * kSubsamples + j, rows_[j]);
      std::copy(rows_[j].surface.begin(), rows_[j].surface.end(),
                surfaces.ptr<std::uint16_t>(y * kSubsamples + j));
      for (std::size_t o = 0; o < alone.size(); ++o) alone[o] += rows_[j].alone[o];
      for (std::uint16_t s : rows_[j].surface)
        if (s > 0) ++visible[object_of_[s - 1]];
    }
    for (int x = 0; x < camera_.width_px; ++x) {
      gather(x);
      const auto pixel = static_cast<std::uint64_t>(y) * camera_.width_px + x;
      ideal.at<float>(y, x) = static_cast<float>(shader_.pixel(samples_, mix(seed_) ^ mix(pixel)));
    }
  }

 private:
  const Camera& camera_;
  const ViewCaster& caster_;
  const Shader& shader_;
  std::uint64_t seed_;
  bool orthographic_;
  Transform world_from_camera_;

  void gather(int x) {
    for (int j = 0; j < kSubsamples; ++j)
      for (int i = 0; i < kSubsamples; ++i) {
        const SampleRow& row = rows_[j];
        const int k = x * kSubsamples + i;
        ShadingSample& sample = samples_[j * kSubsamples + i];
        sample.surface = row.surface[k];
        if (sample.surface > 0)
          sample.point = caster_.world_point(row.x[k], row.y[k], row.depth[k]);
        const Eigen::Vector3d d(row.x[k], row.y[k], 1);
        sample.ray_origin = orthographic_ ? world_from_camera_ * Eigen::Vector3d(d.x(), d.y(), 0)
                                          : world_from_camera_.t;
        sample.ray_direction =
            orthographic_ ? world_from_camera_.R.col(2).eval() : (world_from_camera_.R * d).eval();
      }
  }

 public:
  std::vector<std::int64_t> visible, alone;  ///< samples per object

 private:
  std::vector<std::size_t> object_of_;
  SampleRow rows_[kSubsamples];
  std::vector<ShadingSample> samples_;
};

}  // namespace

RenderedView render_view(const World& world, const Camera& camera, const Sensor& sensor,
                         std::uint64_t seed, int threads) {
  check(world, camera);
  if (threads <= 0) threads = std::max(1u, std::thread::hardware_concurrency());
  const ViewCaster caster(world, camera);
  const Shader shader(world);
  cv::Mat ideal(camera.height_px, camera.width_px, CV_32F);
  RenderedView view;
  view.surfaces.create(camera.height_px * kSubsamples, camera.width_px * kSubsamples, CV_16U);

  std::atomic<int> next_row{0};
  std::vector<RowRenderer> workers(threads, RowRenderer(world, camera, caster, shader, seed));
  std::vector<std::thread> pool;
  for (RowRenderer& worker : workers)
    pool.emplace_back([&] {
      for (int y = next_row++; y < camera.height_px; y = next_row++)
        worker.row(y, ideal, view.surfaces);
    });
  for (std::thread& thread : pool) thread.join();

  for (std::size_t o = 0; o < world.objects.size(); ++o) {
    std::int64_t visible = 0, alone = 0;
    for (const RowRenderer& worker : workers) {
      visible += worker.visible[o];
      alone += worker.alone[o];
    }
    view.visible_fraction.push_back(alone > 0 ? static_cast<double>(visible) / alone : 0);
  }
  view.gray = expose(ideal, sensor, seed);
  return view;
}

}  // namespace trihedron::render
