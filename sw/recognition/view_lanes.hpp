// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

/// Up to four views side by side in the lanes of SIMD registers: one instruction works for all of
/// them. Single precision: a thousandth of a pixel.
struct LaneRig {
  static constexpr std::size_t kLanes = 4;
  using Lanes __attribute__((vector_size(kLanes * sizeof(float)))) = float;

  /// The views from `first` on, as many as fit.
  LaneRig(const std::vector<ViewLines>& views, std::size_t first)
      : count(std::min(kLanes, views.size() - first)) {
    for (std::size_t lane = 0; lane < count; ++lane) {
      const IdealView& view = views[first + lane].ideal;
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 4; ++c) {
          matrix[r][c][lane] = static_cast<float>(
              view.matrix()(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)));
        }
        const auto k = static_cast<Eigen::Index>(r);
        from[r][lane] =
            static_cast<float>(view.orthographic() ? -view.axis()[k] : view.centre()[k]);
      }
      pinhole[lane] = view.orthographic() ? 0.0F : 1.0F;
    }
  }

  std::size_t count;                             ///< views; the other lanes are empty
  std::array<std::array<Lanes, 4>, 3> matrix{};  ///< IdealView::matrix, a lane per view
  std::array<Lanes, 3> from{};                   ///< centre, or backwards direction
  Lanes pinhole{};                               ///< 1, or 0: orthographic
};

/// What the views of a rig see of a model in some pose.
class ViewLanes {
 public:
  using Lanes = LaneRig::Lanes;

  /// Lanes without a view see no surface.
  ViewLanes(const LaneRig& rig, const Transform& world_from_model) : count_(rig.count) {
    const Eigen::Matrix3f R = world_from_model.R.cast<float>();
    const Eigen::Vector3f t = world_from_model.t.cast<float>();
    x_ = turned(rig.matrix[0], R, t);
    y_ = turned(rig.matrix[1], R, t);
    depth_ = turned(rig.matrix[2], R, t);
    const Rows sight = {rig.from[0] - rig.pinhole * t.x(), rig.from[1] - rig.pinhole * t.y(),
                        rig.from[2] - rig.pinhole * t.z(), rig.pinhole};
    sight_ = turned(sight, R, Eigen::Vector3f::Zero());
  }

  std::size_t count() const { return count_; }

  /// Image positions, px, of a point of the model; depth <= 0: behind the camera.
  struct Images {
    Lanes x, y, depth;
  };
  Images project(const Eigen::Vector3f& p) const {
    const Lanes depth = combine(depth_, p);
    return {combine(x_, p) / depth, combine(y_, p) / depth, depth};
  }

  /// Above 0 in the views to which a surface of the model turns; `normal` . x = `offset` on it.
  Lanes facing(const Eigen::Vector3f& normal, float offset) const {
    return sight_[0] * normal.x() + sight_[1] * normal.y() + sight_[2] * normal.z() -
           sight_[3] * offset;
  }

 private:
  using Rows = std::array<Lanes, 4>;  // the columns of a row vector, a lane per view

  static Rows turned(const Rows& row, const Eigen::Matrix3f& R, const Eigen::Vector3f& t) {
    Rows out;
    for (Eigen::Index j = 0; j < 3; ++j) {
      out[static_cast<std::size_t>(j)] = row[0] * R(0, j) + row[1] * R(1, j) + row[2] * R(2, j);
    }
    out[3] = row[0] * t.x() + row[1] * t.y() + row[2] * t.z() + row[3];
    return out;
  }
  static Lanes combine(const Rows& rows, const Eigen::Vector3f& p) {
    return rows[0] * p.x() + rows[1] * p.y() + rows[2] * p.z() + rows[3];
  }

  std::size_t count_;
  Rows x_, y_, depth_;  // homogeneous image position: columns times (p, 1)
  Rows sight_;  // the camera's place (or backwards direction) in the model frame, and 1 (or 0)
};

}  // namespace trihedron
