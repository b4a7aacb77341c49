// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/regions.hpp"

namespace trihedron {

/// The straight-line polygon of a closed chain of contour points, same sense of rotation.
/// `proposals` are points (px) where the chain may bend, e.g. the hardware's vertices; further
/// bends are found where the chain leaves its chord. Sides are total least squares lines through
/// the points between two bends; neighbouring sides that one line fits as well are one side;
/// corners are the intersections of neighbouring sides. Empty when fewer than three sides remain.
ImagePolygon fit_polygon(const std::vector<Eigen::Vector2d>& chain,
                         const std::vector<Eigen::Vector2d>& proposals);

/// Shoelace area in image coordinates, px^2: negative when counter-clockwise on the screen.
double signed_area(const ImagePolygon& polygon);

}  // namespace trihedron
