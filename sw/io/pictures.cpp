// SPDX-License-Identifier: Apache-2.0
#include "io/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "io/file.hpp"
#include "io/image.hpp"
#include "recognition/regions.hpp"
#include "recognition/visibility.hpp"

namespace trihedron {
namespace {

constexpr int kSmallWidthPx = 1000;  // narrower views are drawn at twice their size
constexpr int kSubPixelBits = 4;

int scale_of(const cv::Mat& grey) { return grey.cols < kSmallWidthPx ? 2 : 1; }

cv::Mat enlarged(const cv::Mat& image, int scale, int interpolation) {
  cv::Mat out;
  cv::resize(image, out, {}, scale, scale, interpolation);
  if (out.channels() == 1) cv::cvtColor(out, out, cv::COLOR_GRAY2BGR);
  return out;
}

/// A position in px of the view as a fixed-point position in the enlarged picture.
cv::Point at(const Eigen::Vector2d& x, int scale) {
  const auto fixed = [&](double v) {
    constexpr double kFar = 1e4;  // keeps lines that leave the picture within OpenCV's range
    const double enlarged_px = (v + 0.5) * scale - 0.5;
    return static_cast<int>(
        std::lround(std::clamp(enlarged_px, -kFar, kFar) * (1 << kSubPixelBits)));
  };
  return {fixed(x.x()), fixed(x.y())};
}

/// Brightness of a magnitude: full at half the largest step, square root so that weak edges show.
unsigned char tone(int magnitude) {
  constexpr double kWhite = 24.0 * kGradientScale;  // grey levels per px
  return cv::saturate_cast<unsigned char>(255 * std::sqrt(magnitude / kWhite));
}

/// Colours that stay apart for any number of objects: hues by the golden angle.
cv::Scalar colour_of(std::size_t object) {
  const double hue = std::fmod(60 + 137.508 * static_cast<double>(object), 360) / 2;
  cv::Mat pixel(1, 1, CV_8UC3, cv::Scalar(hue, 210, 255));
  cv::cvtColor(pixel, pixel, cv::COLOR_HSV2BGR);
  const auto& p = pixel.at<cv::Vec3b>(0, 0);
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

cv::Mat flag_mask(const ViewFeatures& features, ContourFlag flag) {
  cv::Mat mask(features.height, features.width, CV_8U);
  for (int y = 0; y < features.height; ++y)
    for (int x = 0; x < features.width; ++x)
      mask.at<unsigned char>(y, x) = (features.at(x, y).flags & flag) != 0 ? 255 : 0;
  return mask;
}

cv::Mat gradient_image(const ViewFeatures& features) {
  cv::Mat image(features.height, features.width, CV_8U);
  for (int y = 0; y < features.height; ++y)
    for (int x = 0; x < features.width; ++x)
      image.at<unsigned char>(y, x) = tone(features.at(x, y).magnitude);
  return image;
}

cv::Mat vertex_image(const cv::Mat& grey, const ViewFeatures& features, int scale) {
  cv::Mat out = enlarged(grey / 2, scale, cv::INTER_LINEAR);
  const cv::Mat mask = enlarged(flag_mask(features, kContour), scale, cv::INTER_NEAREST);
  out.setTo(cv::Scalar(200, 200, 200), mask.reshape(1).reshape(3) > 0);
  for (const Vertex& v : features.vertices) {
    const cv::Scalar colour = v.branches >= 3 ? cv::Scalar(60, 160, 255) : cv::Scalar(90, 230, 90);
    cv::circle(out, at({v.x, v.y}, scale), 3 * scale << kSubPixelBits, colour, 1, cv::LINE_AA,
               kSubPixelBits);
  }
  return out;
}

std::vector<cv::Point> corners(const ImagePolygon& polygon, int scale) {
  std::vector<cv::Point> out;
  for (const Eigen::Vector2d& x : polygon) out.push_back(at(x, scale));
  return out;
}

/// Closed regions in colours over the darkened image, their polygons' corners marked.
cv::Mat region_image(const cv::Mat& grey, const ViewFeatures& features, int scale) {
  cv::Mat out = enlarged(grey / 2, scale, cv::INTER_LINEAR);
  const std::vector<Region> regions = find_regions(features);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::vector<std::vector<cv::Point>> boundaries = {corners(regions[i].outer, scale)};
    for (const ImagePolygon& hole : regions[i].holes) boundaries.push_back(corners(hole, scale));
    cv::Mat filled = out.clone();
    cv::fillPoly(filled, boundaries, colour_of(i), cv::LINE_AA, kSubPixelBits);  // even-odd: holes
    constexpr double kOpacity = 0.35;
    cv::addWeighted(filled, kOpacity, out, 1 - kOpacity, 0, out);
    cv::polylines(out, boundaries, true, colour_of(i), 1, cv::LINE_AA, kSubPixelBits);
    for (const auto& boundary : boundaries)
      for (const cv::Point& corner : boundary)
        cv::circle(out, corner, 2 * scale << kSubPixelBits, {255, 255, 255}, 1, cv::LINE_AA,
                   kSubPixelBits);
  }
  return out;
}

const Model* find_model(const std::vector<Model>& library, int id) {
  for (const Model& model : library)
    if (model.id == id) return &model;
  return nullptr;
}

/// A visible piece as a camera with distortion draws it: straight between short steps.
void draw_edge(cv::Mat& out, const Camera& camera, const VisibleEdge& edge,
               const cv::Scalar& colour, int scale) {
  const int steps = std::max(1, static_cast<int>(edge.length_px / 16));
  Eigen::Vector2d from = camera.project(edge.x0_in_world);
  for (int i = 1; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    const Eigen::Vector2d to =
        camera.project(edge.x0_in_world + s * (edge.x1_in_world - edge.x0_in_world));
    cv::line(out, at(from, scale), at(to, scale), colour, 1, cv::LINE_AA, kSubPixelBits);
    from = to;
  }
}

void write_name(cv::Mat& out, const std::string& text, cv::Point where, const cv::Scalar& colour) {
  cv::putText(out, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.5, {0, 0, 0}, 3, cv::LINE_AA);
  cv::putText(out, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.5, colour, 1, cv::LINE_AA);
}

/// All pictures of a view side by side, `height` px high.
cv::Mat strip(const std::vector<Picture>& pictures, const std::string& view, int height) {
  cv::Mat row;
  for (const Picture& picture : pictures) {
    cv::Mat cell;
    const double scale = static_cast<double>(height) / picture.image.rows;
    cv::resize(picture.image, cell, {}, scale, scale, cv::INTER_AREA);
    write_name(cell, view + ": " + picture.stage, {8, 18}, {255, 255, 255});
    if (row.empty())
      row = cell;
    else
      cv::hconcat(row, cell, row);
  }
  return row;
}

}  // namespace

std::vector<Picture> feature_pictures(const cv::Mat& grey, const ViewFeatures& features) {
  const int scale = scale_of(grey);
  const auto plain = [&](const cv::Mat& image) {
    return enlarged(image, scale, cv::INTER_NEAREST);
  };
  return {{"gradient", plain(gradient_image(features))},
          {"first_contour", plain(flag_mask(features, kFirstContour))},
          {"second_contour", plain(flag_mask(features, kContour))},
          {"vertices", vertex_image(grey, features, scale)},
          {"regions", region_image(grey, features, scale)}};
}

Picture model_picture(const cv::Mat& grey, const Camera& camera, const RecognitionResult& result,
                      const std::vector<Model>& library) {
  const int scale = scale_of(grey);
  Picture picture{"models", enlarged(grey, scale, cv::INTER_LINEAR)};
  std::vector<PlacedModel> placed;
  for (const RecognizedObject& object : result.objects)
    if (const Model* model = find_model(library, object.model_id))
      placed.push_back({model, object.world_from_model});
  for (const VisibleEdge& edge : visible_edges(camera, placed))
    draw_edge(picture.image, camera, edge, colour_of(static_cast<std::size_t>(edge.object)), scale);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Eigen::Vector2d centre = camera.project(placed[i].world_from_model.t);
    const cv::Point where(static_cast<int>(centre.x() * scale) - 30,
                          static_cast<int>(centre.y() * scale));
    write_name(picture.image, placed[i].model->name, where, colour_of(i));
  }
  return picture;
}

void write_pictures(const std::filesystem::path& folder, const Scene& scene,
                    const std::vector<View>& views, const RecognitionResult& result,
                    const std::vector<Model>& library) {
  make_folder(folder);
  cv::Mat overview;
  constexpr int kOverviewRowPx = 300;
  for (std::size_t v = 0; v < views.size(); ++v) {
    std::vector<Picture> pictures = feature_pictures(scene.images[v], views[v].features);
    pictures.push_back(model_picture(scene.images[v], views[v].camera, result, library));
    for (const Picture& picture : pictures)
      write_png(folder / fmt::format("{}_{}.png", views[v].camera.view, picture.stage),
                picture.image);
    const cv::Mat row = strip(pictures, views[v].camera.view, kOverviewRowPx);
    if (overview.empty()) {
      overview = row;
      continue;
    }
    // Views of other proportions get a black margin.
    const int width = std::max(overview.cols, row.cols);
    cv::Mat all(overview.rows + row.rows, width, CV_8UC3, cv::Scalar());
    overview.copyTo(all({0, 0, overview.cols, overview.rows}));
    row.copyTo(all({0, overview.rows, row.cols, row.rows}));
    overview = all;
  }
  write_png(folder / "overview.png", overview);
}

}  // namespace trihedron
