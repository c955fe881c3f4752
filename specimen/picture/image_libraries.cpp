#include "specimen/picture/image_libraries.hpp"

#include <png.h>
#include <tiffio.h>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>

namespace specimen {
namespace {

/// "4.5.0" of "LIBTIFF, Version 4.5.0" and a copyright below.
std::string tiff_version() {
  const std::string line = TIFFGetVersion();
  const std::size_t digit = line.find_first_of("0123456789");
  return digit == std::string::npos ? line : line.substr(digit, line.find('\n') - digit);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> image_libraries() {
  return {{"OpenCV", cv::getVersionString()},
          {"libpng", png_get_libpng_ver(nullptr)},
          {"libtiff", tiff_version()}};
}

// Wiener-Khinchin: the correlation of a picture with itself is the transform of its power spectrum. A rim of
// noughts as wide as the largest shift keeps opposite edges apart; counts are whole numbers, far above what
// the transform rounds.
Raster<std::int64_t> count_pairs(const Raster<std::uint8_t>& set, int most) {
  const int rows = cv::getOptimalDFTSize(set.rows + most), cols = cv::getOptimalDFTSize(set.cols + most);
  cv::Mat values = cv::Mat::zeros(rows, cols, CV_64F);
  for (int row = 0; row < set.rows; ++row)
    for (int col = 0; col < set.cols; ++col) values.at<double>(row, col) = set(row, col);
  cv::dft(values, values);
  cv::mulSpectrums(values, values, values, 0, true);
  cv::dft(values, values, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  Raster<std::int64_t> pairs(most + 1, 2 * most + 1);
  for (int down = 0; down <= most; ++down)
    for (int right = -most; right <= most; ++right)
      pairs(down, most + right) = std::llround(values.at<double>(down, (right + cols) % cols));
  return pairs;
}

}  // namespace specimen
