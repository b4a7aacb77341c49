// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "recognition/crossing.hpp"
#include "recognition/transform.hpp"

namespace trihedron {

/// Up to four views of a model in some pose, side by side in the lanes of SIMD registers: one
/// instruction works for all views. Single precision: a ten-thousandth of a pixel.
class ViewLanes {
 public:
  static constexpr std::size_t kLanes = 4;
  using Lanes = Eigen::Array4f;

  /// The views from `first` on, as many as fit. Lanes without a view see no surface.
  ViewLanes(const std::vector<ViewLines>& views, std::size_t first,
            const Transform& world_from_model)
      : count_(std::min(kLanes, views.size() - first)) {
    x_.setZero();
    y_.setZero();
    depth_.setZero();
    sight_.setZero();
    const Transform& pose = world_from_model;
    for (std::size_t lane = 0; lane < count_; ++lane) {
      const IdealView& view = views[first + lane].ideal;
      Eigen::Matrix<double, 3, 4> P;
      P.leftCols<3>() = view.matrix().leftCols<3>() * pose.R;
      P.col(3) = view.matrix().leftCols<3>() * pose.t + view.matrix().col(3);
      const auto i = static_cast<Eigen::Index>(lane);
      x_.row(i) = P.row(0).cast<float>().array();
      y_.row(i) = P.row(1).cast<float>().array();
      depth_.row(i) = P.row(2).cast<float>().array();
      const Eigen::Vector3d from = view.orthographic() ? Eigen::Vector3d(-view.axis())
                                                       : Eigen::Vector3d(view.centre() - pose.t);
      const Eigen::Vector3d sight = pose.R.transpose() * from;
      sight_.row(i).head<3>() = sight.transpose().cast<float>().array();
      sight_(i, 3) = view.orthographic() ? 0.0F : 1.0F;
    }
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
    return sight_.col(0) * normal.x() + sight_.col(1) * normal.y() + sight_.col(2) * normal.z() -
           sight_.col(3) * offset;
  }

 private:
  using Rows = Eigen::Array<float, 4, 4>;  // a row per view, so that a column is a register

  static Lanes combine(const Rows& rows, const Eigen::Vector3f& p) {
    return rows.col(0) * p.x() + rows.col(1) * p.y() + rows.col(2) * p.z() + rows.col(3);
  }

  std::size_t count_;
  Rows x_, y_, depth_;  // homogeneous image position: columns times (p, 1)
  Rows sight_;  // the camera's place (or backwards direction) in the model frame, and 1 (or 0)
};

}  // namespace trihedron
