#include "apps/drawing/deformed_picture.hpp"

#include <cassert>
#include <limits>
#include <vector>

#include "apps/drawing/nearest_points.hpp"

namespace output {

using specimen::Raster;
using specimen::Rgb;

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
