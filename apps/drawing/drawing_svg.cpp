#include "apps/drawing/drawing_svg.hpp"

#include <fmt/format.h>

#include <string_view>

#include "apps/text/html.hpp"
#include "apps/drawing/png.hpp"

namespace output {
namespace {

std::string_view name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
  }
  return {};
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
