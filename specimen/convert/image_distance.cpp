#include "specimen/convert/image_distance.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace specimen {

Raster<float> distance_to_zero(const Raster<std::uint8_t>& mask) {
  Raster<float> distance(mask.rows, mask.cols, static_cast<float>(mask.rows) + static_cast<float>(mask.cols));
  if (std::find(mask.data.begin(), mask.data.end(), 0) == mask.data.end()) return distance;
  const cv::Mat source(mask.rows, mask.cols, CV_8U, const_cast<std::uint8_t*>(mask.data.data()));
  cv::Mat target(mask.rows, mask.cols, CV_32F, distance.data.data());
  cv::distanceTransform(source, target, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distance;
}

}  // namespace specimen
