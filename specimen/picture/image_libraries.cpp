#include "specimen/picture/image_libraries.hpp"

#include <png.h>
#include <tiffio.h>

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

}  // namespace specimen
