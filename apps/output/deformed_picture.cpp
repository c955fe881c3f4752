#include "apps/output/deformed_picture.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace output {
namespace {

using specimen::Raster;
using specimen::Rgb;

/// How far from a point its colour reaches along both axes [pixels of the mask].
constexpr double reach = 0.75;

/// In pixels of the mask, from its top left corner, down and to the right.
struct Place {
  double x = 0, y = 0;
};

Place place_of(const specimen::LabelledMask& mask, const mpm::Result& result, Eigen::Index pixel) {
  const double x = static_cast<double>(result.end_x.data()[pixel]) / mask.pixel_size;
  const double y = static_cast<double>(result.end_y.data()[pixel]) / mask.pixel_size;
  return {x, mask.labels.rows - y};
}

/// What the picture shows, in pixels of the mask; the last row and column are not in it.
struct Frame {
  int top = 0, left = 0, bottom = 0, right = 0;
};

Frame frame_of(const specimen::LabelledMask& mask, const mpm::Result& result) {
  const int rows = mask.labels.rows;
  const int cols = mask.labels.cols;
  Frame frame{0, 0, rows, cols};
  for (Eigen::Index pixel = 0; pixel < result.end_x.size(); ++pixel) {
    const Place place = place_of(mask, result, pixel);
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) continue;
    const double x = std::clamp(place.x, -0.5 * cols, 1.5 * cols - 1);
    const double y = std::clamp(place.y, -0.5 * rows, 1.5 * rows - 1);
    frame.left = std::min(frame.left, static_cast<int>(std::floor(x)));
    frame.right = std::max(frame.right, static_cast<int>(std::floor(x)) + 1);
    frame.top = std::min(frame.top, static_cast<int>(std::floor(y)));
    frame.bottom = std::max(frame.bottom, static_cast<int>(std::floor(y)) + 1);
  }
  return frame;
}

/// For every pixel of the picture the point next to it.
class Nearest {
 public:
  Nearest(const Frame& frame, int fineness)
      : frame_(frame),
        fineness_(fineness),
        point_((frame.bottom - frame.top) * fineness, (frame.right - frame.left) * fineness, -1),
        distance_(point_.rows, point_.cols, std::numeric_limits<float>::infinity()) {}

  void add(Eigen::Index point, const Place& place) {
    const double x = (place.x - frame_.left) * fineness_;
    const double y = (place.y - frame_.top) * fineness_;
    const double far = reach * fineness_;
    const int top = std::max(0, static_cast<int>(std::ceil(y - far - 0.5)));
    const int left = std::max(0, static_cast<int>(std::ceil(x - far - 0.5)));
    for (int row = top; row < point_.rows && row + 0.5 <= y + far; ++row)
      for (int col = left; col < point_.cols && col + 0.5 <= x + far; ++col) {
        const double square = (col + 0.5 - x) * (col + 0.5 - x) + (row + 0.5 - y) * (row + 0.5 - y);
        const auto distance = static_cast<float>(square);
        if (distance >= distance_(row, col)) continue;
        distance_(row, col) = distance;
        point_(row, col) = static_cast<std::int32_t>(point);
      }
  }

  [[nodiscard]] const Raster<std::int32_t>& points() const { return point_; }

 private:
  Frame frame_;
  int fineness_;
  Raster<std::int32_t> point_;  ///< -1 = none
  Raster<float> distance_;      ///< its square
};

}  // namespace

bool has_end(const mpm::Result& result) { return result.end_x.size() > 0; }

Raster<Rgb> deformed_picture(const specimen::LabelledMask& mask, const mpm::Result& result,
                             const Palette& palette, int fineness) {
  assert(result.end_x.rows() == mask.labels.rows && result.end_x.cols() == mask.labels.cols);
  const Raster<Rgb> colours = damage_picture(mask, result, std::numeric_limits<double>::infinity(), palette);
  Nearest nearest(frame_of(mask, result), fineness);
  for (Eigen::Index pixel = 0; pixel < result.end_x.size(); ++pixel) {
    const Place place = place_of(mask, result, pixel);
    if (std::isfinite(place.x) && std::isfinite(place.y)) nearest.add(pixel, place);
  }
  const Raster<std::int32_t>& points = nearest.points();
  Raster<Rgb> picture(points.rows, points.cols, palette.phases[specimen::phase::void_]);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (points.data[i] >= 0) picture.data[i] = colours.data[static_cast<std::size_t>(points.data[i])];
  return picture;
}

std::string deformed_name(bool colour) { return colour ? "deformed_colour.png" : "deformed.png"; }

}  // namespace output
