#include "apps/drawing/drawing_files.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>
#include <zlib.h>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"

namespace output {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

/// @throws std::runtime_error for what the library says went wrong.
void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("picture: cannot be drawn: ") + cairo_status_to_string(status));
}

/// What the library writes, as bytes.
cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

/// A picture, one pixel a pixel.
Surface surface_of(const specimen::Raster<specimen::Rgb>& picture) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.cols, picture.rows),
                  cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  cairo_surface_flush(surface.get());
  unsigned char* pixels = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < picture.rows; ++row)
    for (int col = 0; col < picture.cols; ++col) {
      const specimen::Rgb colour = picture(row, col);
      const std::uint32_t value = std::uint32_t{colour.r} << 16 | std::uint32_t{colour.g} << 8 | colour.b;
      std::memcpy(pixels + static_cast<std::ptrdiff_t>(row) * stride + 4 * col, &value, sizeof value);
    }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void dip(cairo_t* pen, specimen::Rgb colour) {
  cairo_set_source_rgb(pen, colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
}

void dip(cairo_t* pen, Ink ink) { dip(pen, on_light_paper(ink)); }

struct Draw {
  cairo_t* pen;

  void operator()(const Stroke& stroke) const {
    static constexpr double dashes[] = {6, 4};
    dip(pen, stroke.ink);
    cairo_set_line_width(pen, stroke.width);
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(pen, dashes, stroke.dashed ? 2 : 0, 0);
    for (const Place& place : stroke.places) cairo_line_to(pen, place.x, place.y);
    cairo_stroke(pen);
  }

  void operator()(const Dot& dot) const {
    dip(pen, dot.ink);
    cairo_arc(pen, dot.centre.x, dot.centre.y, dot.radius, 0, 2 * M_PI);
    cairo_fill(pen);
  }

  void operator()(const Words& words) const {
    cairo_set_font_size(pen, words.size);
    cairo_text_extents_t extents;
    cairo_text_extents(pen, words.text.c_str(), &extents);
    const double share = words.anchor == Anchor::start ? 0 : words.anchor == Anchor::middle ? 0.5 : 1;
    const double start = words.at.x - share * extents.x_advance;
    cairo_move_to(pen, start, words.at.y);
    cairo_text_path(pen, words.text.c_str());
    cairo_set_source_rgb(pen, 1, 1, 1);  // a rim of paper parts the words from the lines below
    cairo_set_line_width(pen, 3);
    cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(pen, nullptr, 0, 0);
    cairo_stroke(pen);
    cairo_move_to(pen, start, words.at.y);  // as words, which a reader of the file can search and copy
    dip(pen, words.ink);
    cairo_show_text(pen, words.text.c_str());
    cairo_new_path(pen);
  }

  void operator()(const Block& block) const {
    cairo_rectangle(pen, block.corner.x, block.corner.y, block.width, block.height);
    dip(pen, block.colour);
    cairo_fill_preserve(pen);
    dip(pen, Ink::axis);
    cairo_set_line_width(pen, 0.5);
    cairo_set_dash(pen, nullptr, 0, 0);
    if (block.outlined) cairo_stroke(pen);
    cairo_new_path(pen);
  }

  void operator()(const Area& area) const {
    for (const Place& corner : area.corners) cairo_line_to(pen, corner.x, corner.y);
    dip(pen, area.colour);
    cairo_fill(pen);
  }

  void operator()(const Pixels& pixels) const {
    const Surface surface = surface_of(pixels.picture);
    cairo_save(pen);
    cairo_translate(pen, pixels.corner.x, pixels.corner.y);
    cairo_scale(pen, pixels.width / pixels.picture.cols, pixels.height / pixels.picture.rows);
    cairo_set_source_surface(pen, surface.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(pen), CAIRO_FILTER_NEAREST);
    cairo_paint(pen);
    cairo_restore(pen);
  }
};

/// Draws on white paper with a margin on every side [px of the drawing].
/// @param scale  units of the surface per px of the drawing.
void draw(cairo_surface_t* surface, const Drawing& drawing, double scale, double margin) {
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> pen(cairo_create(surface), cairo_destroy);
  cairo_set_source_rgb(pen.get(), 1, 1, 1);
  cairo_paint(pen.get());
  cairo_scale(pen.get(), scale, scale);
  cairo_translate(pen.get(), margin, margin);
  cairo_select_font_face(pen.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  for (const Shape& shape : drawing.shapes) std::visit(Draw{pen.get()}, shape);
  require(cairo_status(pen.get()));
}

std::string encode(cairo_surface_t* surface) {
  std::string bytes;
  require(cairo_surface_write_to_png_stream(surface, append, &bytes));
  return bytes;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xffU);
  return bytes;
}

/// With a chunk pHYs behind the header of a PNG, which the drawing library does not write.
std::string with_resolution(std::string png, double per_inch) {
  if (!(per_inch > 0)) return png;
  constexpr std::size_t header = 8 + 4 + 4 + 13 + 4;  // signature; length, IHDR, data, checksum
  const std::string per_metre = big_endian(static_cast<std::uint32_t>(std::lround(per_inch / 0.0254)));
  const std::string chunk = "pHYs" + per_metre + per_metre + '\1';
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size()));
  return png.insert(header, big_endian(9) + chunk + big_endian(static_cast<std::uint32_t>(sum)));
}

}  // namespace

std::string png_of(const Drawing& drawing, double scale, double margin, double per_inch) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                 static_cast<int>(std::lround(scale * (drawing.width + 2 * margin))),
                                 static_cast<int>(std::lround(scale * (drawing.height + 2 * margin)))),
      cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  draw(surface.get(), drawing, scale, margin);
  return with_resolution(encode(surface.get()), per_inch);
}

std::string png_of(const specimen::Raster<specimen::Rgb>& picture) {
  return encode(surface_of(picture).get());
}

std::string vector_file(const Drawing& drawing, VectorFormat format, double margin, double points_per_px) {
  const double width = points_per_px * (drawing.width + 2 * margin);
  const double height = points_per_px * (drawing.height + 2 * margin);
  std::string bytes;
  {
    const Surface surface(format == VectorFormat::svg
                              ? cairo_svg_surface_create_for_stream(append, &bytes, width, height)
                              : cairo_pdf_surface_create_for_stream(append, &bytes, width, height),
                          cairo_surface_destroy);
    require(cairo_surface_status(surface.get()));
    if (format == VectorFormat::pdf) {
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                     "");  // not the time of day
    }
    draw(surface.get(), drawing, points_per_px, margin);
    cairo_surface_finish(surface.get());
    require(cairo_surface_status(surface.get()));
  }
  return bytes;
}

namespace {

std::string name_of(Anchor anchor) {
  using enum Anchor;
  return app::word_in({{start, "start"}, {middle, "middle"}, {end, "end"}}, anchor);
}

std::string text_of(const std::vector<Place>& places) {
  std::string text;
  for (const Place& place : places)
    text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", place.x, place.y);
  return text;
}

struct Element {
  std::string operator()(const Stroke& stroke) const {
    return fmt::format("<polyline class=\"stroke-{}\" stroke-width=\"{:.4g}\"{} points=\"{}\"/>\n",
                       output::name_of(stroke.ink), stroke.width,
                       stroke.dashed ? " stroke-dasharray=\"6 4\"" : "", text_of(stroke.places));
  }
  std::string operator()(const Dot& dot) const {
    return fmt::format("<circle class=\"fill-{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.4g}\"/>\n",
                       output::name_of(dot.ink), dot.centre.x, dot.centre.y, dot.radius);
  }
  std::string operator()(const Words& words) const {
    return fmt::format(
        "<text class=\"fill-{}\" x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.4g}\" "
        "text-anchor=\"{}\">{}</text>\n",
        output::name_of(words.ink), words.at.x, words.at.y, words.size, name_of(words.anchor),
        escape(words.text));
  }
  std::string operator()(const Block& block) const {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"{}/>\n",
                       block.corner.x, block.corner.y, block.width, block.height, hex(block.colour),
                       block.outlined ? " class=\"stroke-axis\" stroke-width=\"0.5\"" : "");
  }
  std::string operator()(const Area& area) const {
    return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", text_of(area.corners), hex(area.colour));
  }
  std::string operator()(const Pixels& pixels) const {
    return fmt::format(
        "<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" style=\"image-rendering: "
        "pixelated\" "
        "href=\"{}\"/>\n",
        pixels.corner.x, pixels.corner.y, pixels.width, pixels.height, png_address(png_of(pixels.picture)));
  }
};

}  // namespace

std::string svg_of(const Drawing& drawing) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.4g} {:.4g}\" role=\"img\" "
      "aria-label=\"{}\">\n",
      drawing.width, drawing.height, escape(drawing.title));
  for (const Shape& shape : drawing.shapes) svg += std::visit(Element{}, shape);
  return svg + "</svg>\n";
}

}  // namespace output
