#include "apps/drawing/deformed_picture.hpp"

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
PointPlace in_pixels(const specimen::LabelledMask& mask, const PointPlace& place) {
  return {place.x / mask.pixel_size, mask.labels.rows - place.y / mask.pixel_size};
}

bool is_somewhere(const PointPlace& place) { return std::isfinite(place.x) && std::isfinite(place.y); }

/// What the picture shows, in pixels of the mask; the last row and column are not in it.
struct Window {
  int top = 0, left = 0, bottom = 0, right = 0;
};

Window frame_of(const specimen::LabelledMask& mask, const std::vector<PointPlace>& points) {
  const int rows = mask.labels.rows;
  const int cols = mask.labels.cols;
  Window frame{0, 0, rows, cols};
  for (const PointPlace& point : points) {
    if (!is_somewhere(point)) continue;
    const PointPlace place = in_pixels(mask, point);
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
  Nearest(const Window& frame, int fineness)
      : frame_(frame),
        fineness_(fineness),
        point_((frame.bottom - frame.top) * fineness, (frame.right - frame.left) * fineness, -1),
        distance_(point_.rows, point_.cols, std::numeric_limits<float>::infinity()) {}

  void add(std::size_t point, const PointPlace& place) {
    const double x = (place.x - frame_.left) * fineness_;
    const double y = (place.y - frame_.top) * fineness_;
    const double far = reach * fineness_;
    // Clamped as a double: a point may be too far away for an int.
    const int top = static_cast<int>(std::clamp(std::ceil(y - far - 0.5), 0.0, 1.0 * point_.rows));
    const int left = static_cast<int>(std::clamp(std::ceil(x - far - 0.5), 0.0, 1.0 * point_.cols));
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
  Window frame_;
  int fineness_;
  Raster<std::int32_t> point_;  ///< -1 = none
  Raster<float> distance_;      ///< its square
};

}  // namespace

Raster<std::int32_t> nearest_points(const specimen::LabelledMask& mask, const std::vector<PointPlace>& points,
                                    int fineness) {
  Nearest nearest(frame_of(mask, points), fineness);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_somewhere(points[i])) nearest.add(i, in_pixels(mask, points[i]));
  return nearest.points();
}

bool has_end(const mpm::Result& result) { return result.end_x.size() > 0; }

Raster<Rgb> deformed_picture(const specimen::LabelledMask& mask, const mpm::Result& result,
                             const Palette& palette, int fineness) {
  assert(result.end_x.rows() == mask.labels.rows && result.end_x.cols() == mask.labels.cols);
  const Raster<Rgb> colours = damage_picture(mask, result, std::numeric_limits<double>::infinity(), palette);
  std::vector<PointPlace> places;
  places.reserve(colours.size());
  for (Eigen::Index pixel = 0; pixel < result.end_x.size(); ++pixel)
    places.push_back(
        {static_cast<double>(result.end_x.data()[pixel]), static_cast<double>(result.end_y.data()[pixel])});
  const Raster<std::int32_t> points = nearest_points(mask, places, fineness);
  Raster<Rgb> picture(points.rows, points.cols, palette.phases[specimen::phase::void_]);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (points.data[i] >= 0) picture.data[i] = colours.data[static_cast<std::size_t>(points.data[i])];
  return picture;
}

std::string deformed_name(bool colour) { return colour ? "deformed_colour.png" : "deformed.png"; }

}  // namespace output
