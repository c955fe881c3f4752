#include "apps/output/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/output/chart_layout.hpp"
#include "apps/output/drawing_svg.hpp"
#include "apps/output/html.hpp"
#include "apps/output/picture_scale.hpp"
#include "apps/output/png.hpp"
#include "apps/output/report_style.hpp"

namespace output {
namespace {

constexpr int shown_pixels = 360;     ///< a picture's largest width on the page
constexpr int embedded_pixels = 900;  ///< a picture's largest side in the file

/// The page asks for nothing outside itself and runs nothing.
constexpr const char* policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

std::string head(const std::string& title) {
  return fmt::format(
      "<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n",
      policy, escape(title), report_style());
}

}  // namespace

std::string page(const std::string& title, const std::string& html) {
  return "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n" + head(title) +
         "<body>\n<main>\n" + html + "</main>\n</body>\n</html>\n";
}

std::string section(const std::string& heading, const std::string& html) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escape(heading), html);
}

std::string paragraph(const std::string& text) { return fmt::format("<p>{}</p>\n", escape(text)); }

std::string side_by_side(const std::string& css_class, const std::string& left_html,
                         const std::string& right_html) {
  return fmt::format("<div class=\"pair {}\">\n<div>\n{}</div>\n<div>\n{}</div>\n</div>\n", css_class,
                     left_html, right_html);
}

std::string facts_table(const std::vector<Fact>& facts) {
  std::string html = "<table class=\"facts\">\n<tbody>\n";
  for (const Fact& fact : facts)
    html += fact.unit.empty()
                ? fmt::format("<tr class=\"words\"><th scope=\"row\">{}</th><td colspan=\"2\">{}</td></tr>\n",
                              escape(fact.name), escape(fact.value))
                : fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"unit\">{}</td></tr>\n",
                              escape(fact.name), escape(fact.value), escape(fact.unit));
  return html + "</tbody>\n</table>\n";
}

std::string number_table(const std::vector<std::string>& head,
                         const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\">\n<table class=\"numbers\">\n<thead><tr>";
  for (const std::string& name : head) html += fmt::format("<th scope=\"col\">{}</th>", escape(name));
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escape(row.front()));
    for (std::size_t i = 1; i < row.size(); ++i) html += fmt::format("<td>{}</td>", escape(row[i]));
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string chart_figure(const Chart& chart, double width, double height, const std::string& caption) {
  return fmt::format(
      "<figure class=\"chart\">\n<div class=\"wide\">\n{}</div>\n<div class=\"narrow\">\n{}</div>\n"
      "<figcaption>{}</figcaption>\n</figure>\n",
      svg_of(lay_out(chart, width, height)), svg_of(lay_out(chart, 350, 300)), escape(caption));
}

std::string image(const specimen::Raster<specimen::Rgb>& picture, const std::string& alternative,
                  const std::string& css_class) {
  const auto embedded = shrunk(picture, shrink_factor(picture.rows, picture.cols, embedded_pixels));
  const bool is_small = embedded.cols <= shown_pixels;
  const int width = is_small ? shown_pixels / embedded.cols * embedded.cols : shown_pixels;
  const int height = std::max(1, width * embedded.rows / embedded.cols);
  return fmt::format("<img class=\"{}{}\" width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\"/>\n", css_class,
                     is_small ? " pixels" : "", width, height, escape(alternative),
                     png_address(png_of(embedded)));
}

std::string swatch(specimen::Rgb colour, const std::string& name) {
  return fmt::format("<span class=\"swatch\"><i style=\"background:{}\"></i>{}</span>\n", hex(colour),
                     escape(name));
}

std::string folded(const std::string& heading, const std::string& text) {
  return fmt::format("<details>\n<summary>{}</summary>\n<pre>{}</pre>\n</details>\n", escape(heading),
                     escape(text));
}

}  // namespace output
