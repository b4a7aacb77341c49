// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace trihedron {

/// A chessboard by its inner corners, where four squares meet.
struct Board {
  int columns = 0;  ///< inner corners in a row
  int rows = 0;
  double square_mm = 0;  ///< side of a square
};

/// "9x6" as a board with squares of `square_mm`. Throws Error when it is no such text, when the
/// board is too small, or when a half turn maps it onto itself (columns + rows even): cameras on
/// different sides would not agree which corner is the first.
Board parse_board(const std::string& text, double square_mm);

/// The corners in the board's frame, mm, row by row. Board frame: origin at the first corner, x
/// along the rows, y down the columns, z into the board; squares right below the first corner dark.
std::vector<Eigen::Vector3d> board_points(const Board& board);

/// The board's corners in an 8-bit grey image, px, in the order of board_points(), to a fraction of
/// a pixel. Empty when not every corner is found. The same corner comes first in every view.
std::vector<cv::Point2f> find_board(const cv::Mat& grey, const Board& board);

}  // namespace trihedron
