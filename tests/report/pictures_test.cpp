// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "report/data_uri.hpp"
#include "report/picture_layers.hpp"

using namespace trihedron;

namespace {

/// A frame of 3 x 2 beats: magnitudes 0, 1 .. 5 times `step`; pixel (1, 0) on both contours, (2, 1)
/// on the first only.
ViewFeatures small_frame(int step) {
  ViewFeatures features;
  features.width = 3;
  features.height = 2;
  features.contour.resize(6);
  for (std::size_t i = 0; i < 6; ++i)
    features.contour[i].magnitude = static_cast<std::uint16_t>(i * static_cast<std::size_t>(step));
  features.contour[1].flags = kContour | kFirstContour;
  features.contour[5].flags = kFirstContour;
  return features;
}

}  // namespace

TEST_CASE("base64 gives the examples of RFC 4648") {
  const auto encode = [](const std::string& text) {
    return report::base64({text.begin(), text.end()});
  };
  CHECK(encode("") == "");
  CHECK(encode("f") == "Zg==");
  CHECK(encode("fo") == "Zm8=");
  CHECK(encode("foo") == "Zm9v");
  CHECK(encode("foobar") == "Zm9vYmFy");
  CHECK(report::base64({0xff, 0xfe, 0xfd}) == "//79");
}

TEST_CASE("a picture in a data address is a PNG") {
  const std::string uri = report::png_data_uri(cv::Mat(4, 4, CV_8U, 7.0));
  CHECK(uri.substr(0, 33) == "data:image/png;base64,iVBORw0KGgo");  // PNG's signature
}

TEST_CASE("the gradient's picture is black at none and white at 24 grey levels per px and more") {
  const cv::Mat picture = report::gradient_picture(small_frame(24 * kGradientScale));
  CHECK(picture.at<unsigned char>(0, 0) == 0);
  CHECK(picture.at<unsigned char>(0, 1) == 255);
  CHECK(picture.at<unsigned char>(1, 2) == 255);
  const cv::Mat weak = report::gradient_picture(small_frame(6 * kGradientScale));
  CHECK(weak.at<unsigned char>(0, 1) > 110);  // a quarter of white shows at half its tone
  CHECK(weak.at<unsigned char>(0, 1) < 140);
}

TEST_CASE("a contour's picture shows the pixels with its flag and nothing else") {
  const cv::Vec3b colour{1, 2, 3};
  const cv::Mat second = report::contour_picture(small_frame(1), kContour, colour);
  const cv::Mat first = report::contour_picture(small_frame(1), kFirstContour, colour);
  CHECK(second.at<cv::Vec4b>(0, 1) == cv::Vec4b(1, 2, 3, 255));
  CHECK(second.at<cv::Vec4b>(1, 2) == cv::Vec4b());
  CHECK(first.at<cv::Vec4b>(1, 2) == cv::Vec4b(1, 2, 3, 255));
  CHECK(first.at<cv::Vec4b>(0, 0) == cv::Vec4b());
}
