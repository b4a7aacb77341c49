// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>

namespace trihedron::report {

using Json = nlohmann::ordered_json;

/// `value` with the decimals that a drawing needs; what is not finite becomes null.
inline Json rounded(double value, int decimals) {
  if (!std::isfinite(value)) return nullptr;
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;  // no -0
}

/// Appends the coordinates of a point to a flat list: px with two decimals.
inline void append(Json& list, const Eigen::Vector2d& x_px) {
  for (int i = 0; i < 2; ++i) list.push_back(rounded(x_px[i], 2));
}

/// The same in space: mm with three decimals.
inline void append(Json& list, const Eigen::Vector3d& x_mm) {
  for (int i = 0; i < 3; ++i) list.push_back(rounded(x_mm[i], 3));
}

template <typename Vector>
Json numbers(const Vector& x) {
  Json list = Json::array();
  append(list, x);
  return list;
}

}  // namespace trihedron::report
