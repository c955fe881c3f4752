#include "apps/report/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "apps/drawing/chart.hpp"
#include "apps/drawing/drawing_files.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/text/markup.hpp"
#include "specimen/body/files.hpp"

namespace output {
namespace {

constexpr int shown_pixels = 360;     ///< a picture's largest width on the page
constexpr int embedded_pixels = 900;  ///< a picture's largest side in the file

std::string page_of(const std::string& title, const std::string& policy, const std::string& style,
                    const std::string& html) {
  return fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n"
      "<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n{}</body>\n</html>\n",
      policy, escape(title), style, html);
}

/// The page asks for nothing outside itself.
constexpr const char* no_network = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// A script as the browser runs it and as an XML parser passes over it.
std::string script_text(std::string_view body) { return fmt::format("/*<![CDATA[*/\n{}\n/*]]>*/", body); }

/// "'sha256-...'": the name by which a policy knows a script.
std::string digest_of(const std::string& script) {
  const std::string digest = specimen::sha256_of_text(script);
  std::string bytes;
  for (std::size_t i = 0; i < digest.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digest.substr(i, 2), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

/// @param more  a script that follows that of reports; may be empty.
std::string scripted_page(const std::string& title, const std::string& policy, const std::string& html,
                          const std::string& data, std::string_view more) {
  const std::string script = script_text(
      fmt::format("{}\nconst gifenc = (() => {{\nconst exports = {{}};\n{}\nreturn exports;\n}})();\n{}{}",
                  chart_library(), animation_library(), report_script(), more));
  return page_of(
      title, fmt::format("{}; script-src {}", policy, digest_of(script)),
      report_style() + std::string(chart_style()) + "\n",
      fmt::format(
          "{}</main>\n<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n", html,
          data, script));
}

}  // namespace

std::string page(const std::string& title, const std::string& html) {
  return page_of(title, no_network, report_style(), html + "</main>\n");
}

std::string live_page(const std::string& title, const std::string& html, const std::string& data) {
  return scripted_page(title, no_network, html, data, "");
}

std::string watching_page(const std::string& title, const std::string& html, const std::string& data) {
  return scripted_page(title, fmt::format("{}; connect-src 'self'", no_network), html, data,
                       watching_script());
}

std::string editing_page(const std::string& title, const std::string& html, const std::string& data) {
  const std::string script = script_text(editing_script());
  return page_of(
      title, fmt::format("{}; connect-src 'self'; script-src {}", no_network, digest_of(script)),
      report_style() + std::string(editing_style()) + "\n",
      fmt::format(
          "{}</main>\n<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n", html,
          data, script));
}

std::string part(const std::string& id, const std::string& html) {
  return fmt::format("<div id=\"part-{}\">\n{}</div>\n", id, html);
}

std::string heading(const std::string& title, const std::string& setting) {
  return fmt::format("<header>\n<h1>{}</h1>\n<p class=\"setting\">{}</p>\n</header>\n", escape(title),
                     escape(setting));
}

std::string section(const std::string& heading, const std::string& html) {
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escape(heading), html);
}

std::string paragraph(const std::string& text) { return fmt::format("<p>{}</p>\n", escape(text)); }

std::string standing(const std::string& heading, const std::function<std::string()>& make) {
  try {
    return make();
  } catch (const std::exception& fault) {
    return section(heading, paragraph(std::string("This section could not be made: ") + fault.what() +
                                      ". All other sections are complete."));
  }
}

std::string remarks(const std::string& html) { return "<div class=\"remarks\">\n" + html + "</div>\n"; }

std::string pictures(const std::string& html) { return "<div class=\"pictures\">\n" + html + "</div>\n"; }

std::string notes_list(const std::vector<std::string>& notes) {
  std::string html;
  for (const std::string& note : notes) html += fmt::format("<li>{}</li>\n", escape(note));
  return "<ul class=\"notes\">\n" + html + "</ul>\n";
}

std::string warnings_section(const std::vector<std::string>& doubts) {
  return doubts.empty() ? "" : section("Warnings", notes_list(doubts));
}

std::string side_by_side(const std::string& css_class, const std::string& left_html,
                         const std::string& right_html) {
  return fmt::format("<div class=\"pair {}\">\n<div>\n{}</div>\n<div>\n{}</div>\n</div>\n", css_class,
                     left_html, right_html);
}

std::string in_pairs(const std::vector<std::string>& htmls) {
  std::string html;
  for (std::size_t i = 0; i < htmls.size(); i += 2)
    html += side_by_side("even", htmls[i], i + 1 < htmls.size() ? htmls[i + 1] : "");
  return html;
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

std::string table(const std::string& css_class, const std::vector<std::string>& head,
                  const std::string& rows_html) {
  std::string html = fmt::format("<div class=\"scroll\">\n<table class=\"{}\">\n<thead><tr>", css_class);
  for (const std::string& name : head) html += fmt::format("<th scope=\"col\">{}</th>", escape(name));
  return html + "</tr></thead>\n<tbody>\n" + rows_html + "</tbody>\n</table>\n</div>\n";
}

std::string number_table(const std::vector<std::string>& head,
                         const std::vector<std::vector<std::string>>& rows) {
  std::string html;
  for (const auto& row : rows) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", escape(row.front()));
    for (std::size_t i = 1; i < row.size(); ++i) html += fmt::format("<td>{}</td>", escape(row[i]));
    html += "</tr>\n";
  }
  return table("numbers", head, html);
}

std::string chart_figure(const std::string& id, const Chart& chart, double width, double height,
                         const std::string& caption) {
  const std::string live = id.empty() ? "" : fmt::format("<div class=\"live\" id=\"chart-{}\"></div>\n", id);
  return fmt::format(
      "<figure class=\"chart\">\n{}<div class=\"wide\">\n{}</div>\n<div class=\"narrow\">\n{}</div>\n"
      "<figcaption>{}</figcaption>\n</figure>\n",
      live, svg_of(lay_out(chart, width, height)), svg_of(lay_out(chart, 350, 300)), escape(caption));
}

std::string chart_figure(const Chart& chart, double width, double height, const std::string& caption) {
  return chart_figure("", chart, width, height, caption);
}

std::string chart_place(const std::string& id, const std::string& caption) {
  return fmt::format(
      "<figure class=\"chart\" hidden=\"hidden\">\n<div class=\"live\" id=\"chart-{}\"></div>\n"
      "<figcaption>{}</figcaption>\n</figure>\n",
      id, escape(caption));
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

std::string legend(const std::string& css_class, const std::vector<LegendEntry>& entries) {
  std::string html = fmt::format("<p class=\"legend{}{}\">\n", css_class.empty() ? "" : " ", css_class);
  for (const LegendEntry& entry : entries) html += swatch(entry.colour, entry.name);
  return html + "</p>\n";
}

std::string folded(const std::string& heading, const std::string& text) {
  return fmt::format("<details>\n<summary>{}</summary>\n<pre>{}</pre>\n</details>\n", escape(heading),
                     escape(text));
}

}  // namespace output
