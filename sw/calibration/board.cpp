// SPDX-License-Identifier: Apache-2.0
#include "calibration/board.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "golden/error.hpp"

namespace trihedron {
namespace {

using Corners = std::vector<cv::Point2f>;

/// Twice the signed area of a, b, c: positive when they turn as x turns to y.
double turn(const cv::Point2f& a, const cv::Point2f& b, const cv::Point2f& c) {
  return static_cast<double>(b.x - a.x) * (c.y - a.y) -
         static_cast<double>(b.y - a.y) * (c.x - a.x);
}

/// Mean grey around the middle of the square with corner (column, row) at its top left.
double square_grey(const cv::Mat& grey, const Board& board, const Corners& corners, int column,
                   int row) {
  const auto at = [&](int c, int r) {
    return corners[static_cast<std::size_t>(r * board.columns + c)];
  };
  const cv::Point2f middle =
      (at(column, row) + at(column + 1, row) + at(column, row + 1) + at(column + 1, row + 1)) / 4;
  const int x = std::clamp(static_cast<int>(std::lround(middle.x)), 0, grey.cols - 1);
  const int y = std::clamp(static_cast<int>(std::lround(middle.y)), 0, grey.rows - 1);
  const cv::Rect around(std::max(0, x - 1), std::max(0, y - 1), 3, 3);
  return cv::mean(grey(around & cv::Rect(0, 0, grey.cols, grey.rows)))[0];
}

/// Mean grey of the squares that are dark on a board in the right order, less that of the others.
double contrast(const cv::Mat& grey, const Board& board, const Corners& corners) {
  double sum = 0;
  for (int r = 0; r + 1 < board.rows; ++r)
    for (int c = 0; c + 1 < board.columns; ++c)
      sum += ((r + c) % 2 == 0 ? 1 : -1) * square_grey(grey, board, corners, c, r);
  return sum;
}

/// Rows to the right and columns downwards as seen on the board's face, dark squares where they
/// belong: one of the orders in which a detector may have found the corners.
void put_in_order(const cv::Mat& grey, const Board& board, Corners& corners) {
  const auto columns = static_cast<std::size_t>(board.columns);
  if (turn(corners.front(), corners[columns - 1], corners.back()) < 0)  // mirrored: rows reversed
    for (std::size_t r = 0; r < static_cast<std::size_t>(board.rows) / 2; ++r)
      std::swap_ranges(corners.begin() + static_cast<long>(r * columns),
                       corners.begin() + static_cast<long>((r + 1) * columns),
                       corners.end() - static_cast<long>((r + 1) * columns));
  if (contrast(grey, board, corners) > 0) std::reverse(corners.begin(), corners.end());
}

/// Half the side of the window in which a corner is placed: a third of the way to the nearest other
/// one, so that foreshortened neighbours stay outside.
int window_px(const Board& board, const Corners& corners) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (i % static_cast<std::size_t>(board.columns) != 0)
      nearest = std::min(nearest, cv::norm(corners[i] - corners[i - 1]));
    if (i >= static_cast<std::size_t>(board.columns))
      nearest = std::min(
          nearest, cv::norm(corners[i] - corners[i - static_cast<std::size_t>(board.columns)]));
  }
  constexpr int kLeast = 2, kMost = 11;
  return std::clamp(static_cast<int>(nearest / 3), kLeast, kMost);
}

}  // namespace

Board parse_board(const std::string& text, double square_mm) {
  Board board;
  board.square_mm = square_mm;
  char end = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &board.columns, &board.rows, &end) != 2)
    throw Error("--board: is " + text + "; expected inner corners such as 9x6");
  constexpr int kLeast = 3, kMost = 100;
  if (std::min(board.columns, board.rows) < kLeast || std::max(board.columns, board.rows) > kMost)
    throw Error("--board: is " + text + "; expected 3 to 100 inner corners along each side");
  if ((board.columns + board.rows) % 2 == 0)
    throw Error("--board: " + text +
                " looks the same after a half turn, so cameras cannot agree on its first corner; "
                "expected an even and an odd number of inner corners, such as 9x6");
  if (!(square_mm > 0)) throw Error("--square: expected the side of a square, more than 0 mm");
  return board;
}

std::vector<Eigen::Vector3d> board_points(const Board& board) {
  std::vector<Eigen::Vector3d> points;
  for (int r = 0; r < board.rows; ++r)
    for (int c = 0; c < board.columns; ++c)
      points.emplace_back(c * board.square_mm, r * board.square_mm, 0);
  return points;
}

std::vector<cv::Point2f> find_board(const cv::Mat& grey, const Board& board) {
  const cv::Size pattern(board.columns, board.rows);
  Corners corners;
  // The first is quick and sees steep boards, the second finds a few blurred ones beside.
  const bool found =
      cv::findChessboardCornersSB(grey, pattern, corners, cv::CALIB_CB_NORMALIZE_IMAGE) ||
      cv::findChessboardCorners(
          grey, pattern, corners,
          cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK);
  if (!found) return {};
  const int half = window_px(board, corners);
  constexpr int kMaxSteps = 50;
  constexpr double kConverged_px = 1e-3;
  cv::cornerSubPix(grey, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, kMaxSteps, kConverged_px});
  put_in_order(grey, board, corners);
  return corners;
}

}  // namespace trihedron
