#include "specimen/convert/sketch.hpp"

#include <algorithm>
#include <cmath>

#include "specimen/convert/levels.hpp"
#include "specimen/convert/smoothing.hpp"

namespace specimen {
namespace {

/// Of each square the pixel in the middle.
Raster<std::uint8_t> thinned(const Raster<std::uint8_t>& values, int factor) {
  if (values.empty()) return {};
  Raster<std::uint8_t> part((values.rows + factor - 1) / factor, (values.cols + factor - 1) / factor);
  for (int r = 0; r < part.rows; ++r)
    for (int c = 0; c < part.cols; ++c)
      part(r, c) = values(std::min(values.rows - 1, r * factor + factor / 2),
                          std::min(values.cols - 1, c * factor + factor / 2));
  return part;
}

/// A radius in pixels; 0 and "automatic" stay as they are.
int divided(int radius, int factor) {
  return radius <= 0 ? radius
                     : std::max(1, static_cast<int>(std::lround(static_cast<double>(radius) / factor)));
}

Crop divided(const Crop& crop, const Sketch& sketch) {
  if (crop.width == 0 || sketch.factor == 1) return crop;
  Crop part{crop.x / sketch.factor, crop.y / sketch.factor, 0, 0};
  const auto edge = [&](int size, int begin, int whole) {
    return std::min(whole - begin,
                    std::max(1, static_cast<int>(std::lround(static_cast<double>(size) / sketch.factor))));
  };
  part.width = edge(crop.width, part.x, sketch.picture.cols());
  part.height = edge(crop.height, part.y, sketch.picture.rows());
  return part;
}

}  // namespace

Sketch sketch_of(const Picture& whole, double most_pixels) {
  Sketch sketch{{}, 1, whole.rows(), whole.cols()};
  const double parts = std::sqrt(static_cast<double>(whole.rows()) * whole.cols() / most_pixels);
  sketch.factor = std::max(1, static_cast<int>(std::ceil(parts)));
  if (sketch.factor == 1) {
    sketch.picture = whole;
    return sketch;
  }
  sketch.picture.colour = shrunk(shown_colours(whole), sketch.factor);
  sketch.picture.opacity = thinned(whole.opacity, sketch.factor);
  sketch.picture.pixel_size = whole.pixel_size * sketch.factor;
  sketch.picture.pixel_aspect = whole.pixel_aspect;
  sketch.picture.lossy = whole.lossy;
  return sketch;
}

ConvertOptions options_for(const Sketch& sketch, ConvertOptions options) {
  const int factor = sketch.factor;
  if (factor == 1) return options;
  if (options.width > 0) {  // its last column may cover less than a square
    const int cols = options.crop.width > 0 ? options.crop.width : sketch.cols;
    const Crop part = divided(options.crop, sketch);
    const int left = part.width > 0 ? part.width : sketch.picture.cols();
    options.width *= static_cast<double>(left) * factor / cols;
  }
  options.crop = divided(options.crop, sketch);
  options.source_pixel_size *= factor;
  options.smooth = divided(options.smooth, factor);
  options.open = divided(options.open, factor);
  options.close = divided(options.close, factor);
  if (options.pixels > sketch.picture.cols()) options.pixels = 0;
  for (StrokeLine& line : options.stroke_lines) {
    line.width = std::max(1.0, line.width / factor);
    for (auto& [x, y] : line.points) {
      x = std::min(x / factor, static_cast<double>(sketch.picture.cols()));
      y = std::min(y / factor, static_cast<double>(sketch.picture.rows()));
    }
  }
  return options;
}

}  // namespace specimen
