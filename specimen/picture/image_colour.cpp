#include "specimen/picture/image_colour.hpp"

#include <algorithm>
#include <cassert>
#include <opencv2/imgproc.hpp>

namespace specimen {
namespace {

/// OpenCV's view of a raster of three bytes a pixel; nothing is copied.
template <class T>
cv::Mat view(const Raster<T>& raster) {
  static_assert(sizeof(T) == 3);
  return {raster.rows, raster.cols, CV_8UC3, const_cast<T*>(raster.data.data())};
}

double hue(Rgb c) {
  const int high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b});
  const double span = high - low;
  if (span == 0) return 0;
  if (high == c.r) return 60 * (c.g - c.b) / span + (c.g < c.b ? 360 : 0);
  if (high == c.g) return 60 * (c.b - c.r) / span + 120;
  return 60 * (c.r - c.g) / span + 240;
}

double saturation(Rgb c) {
  const double high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b});
  return high == 0 ? 0 : 255 * (high - low) / high;
}

template <class T, class Value>
Raster<double> each(const Raster<T>& picture, Value value) {
  Raster<double> channel(picture.rows, picture.cols);
  std::transform(picture.data.begin(), picture.data.end(), channel.data.begin(), value);
  return channel;
}

}  // namespace

std::string colour_text(Rgb colour) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
    text += digits[channel / 16];
    text += digits[channel % 16];
  }
  return text;
}

Raster<Lab> to_lab(const Raster<Rgb>& picture) {
  Raster<Lab> lab(picture.rows, picture.cols);
  cv::Mat target = view(lab);
  cv::cvtColor(view(picture), target, cv::COLOR_RGB2Lab);
  return lab;
}

const std::vector<std::string>& channel_names() {
  static const std::vector<std::string> names{"gray",       "red",   "green", "blue", "hue",
                                              "saturation", "value", "l",     "a",    "b"};
  return names;
}

Raster<double> channel_of(const Raster<Rgb>& picture, const std::string& name) {
  if (name == "gray")
    return each(picture, [](Rgb c) { return (299 * c.r + 587 * c.g + 114 * c.b) / 1000.0; });
  if (name == "red") return each(picture, [](Rgb c) { return c.r; });
  if (name == "green") return each(picture, [](Rgb c) { return c.g; });
  if (name == "blue") return each(picture, [](Rgb c) { return c.b; });
  if (name == "hue") return each(picture, hue);
  if (name == "saturation") return each(picture, saturation);
  if (name == "value") return each(picture, [](Rgb c) { return std::max({c.r, c.g, c.b}); });
  if (name == "l") return each(to_lab(picture), [](Lab c) { return c.l(); });
  if (name == "a") return each(to_lab(picture), [](Lab c) { return c.a(); });
  assert(name == "b");
  return each(to_lab(picture), [](Lab c) { return c.b(); });
}

Raster<Rgb> median_of(const Raster<Rgb>& picture, int edge) {
  Raster<Rgb> smooth(picture.rows, picture.cols);
  cv::Mat target = view(smooth);
  cv::medianBlur(view(picture), target, edge);
  return smooth;
}

Raster<float> distance_to_zero(const Raster<std::uint8_t>& mask) {
  Raster<float> distance(mask.rows, mask.cols, static_cast<float>(mask.rows) + static_cast<float>(mask.cols));
  if (std::find(mask.data.begin(), mask.data.end(), 0) == mask.data.end()) return distance;
  const cv::Mat source(mask.rows, mask.cols, CV_8U, const_cast<std::uint8_t*>(mask.data.data()));
  cv::Mat target(mask.rows, mask.cols, CV_32F, distance.data.data());
  cv::distanceTransform(source, target, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distance;
}

}  // namespace specimen
