#include "apps/drawing/vector_file.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "apps/drawing/cairo_drawing.hpp"

namespace output {

std::string vector_file(const Drawing& drawing, VectorFormat format, double margin) {
  constexpr double points_per_px = 0.75;
  const double width = points_per_px * (drawing.width + 2 * margin);
  const double height = points_per_px * (drawing.height + 2 * margin);
  std::string bytes;
  {
    const cairo::Surface surface(
        format == VectorFormat::svg
            ? cairo_svg_surface_create_for_stream(cairo::append, &bytes, width, height)
            : cairo_pdf_surface_create_for_stream(cairo::append, &bytes, width, height),
        cairo_surface_destroy);
    cairo::require(cairo_surface_status(surface.get()));
    if (format == VectorFormat::pdf) {
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                     "");  // not the time of day
    }
    cairo::draw(surface.get(), drawing, points_per_px, margin);
    cairo_surface_finish(surface.get());
    cairo::require(cairo_surface_status(surface.get()));
  }
  return bytes;
}

}  // namespace output
