#include "apps/drawing/png.hpp"

#include <cmath>

#include "apps/drawing/cairo_drawing.hpp"

namespace output {
namespace {

std::string encode(cairo_surface_t* surface) {
  std::string bytes;
  cairo::require(cairo_surface_write_to_png_stream(surface, cairo::append, &bytes));
  return bytes;
}

}  // namespace

std::string png_of(const Drawing& drawing, double scale, double margin) {
  const cairo::Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                 static_cast<int>(std::lround(scale * (drawing.width + 2 * margin))),
                                 static_cast<int>(std::lround(scale * (drawing.height + 2 * margin)))),
      cairo_surface_destroy);
  cairo::require(cairo_surface_status(surface.get()));
  cairo::draw(surface.get(), drawing, scale, margin);
  return encode(surface.get());
}

std::string png_of(const specimen::Raster<specimen::Rgb>& picture) {
  return encode(cairo::surface_of(picture).get());
}

}  // namespace output
