#include "apps/twin/twin_report.hpp"

#include <fmt/format.h>

#include "apps/text/html.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/text.hpp"
#include "apps/twin/twin_charts.hpp"
#include "apps/twin/twin_words.hpp"
#include "specimen/picture/preview.hpp"

namespace app {
namespace {

using output::escape;
using output::section;

std::string figure(const specimen::Raster<specimen::Rgb>& picture, const std::string& name,
                   const specimen::Descriptors& d) {
  return fmt::format(
      "<figure>\n{}<figcaption><b>{}</b><br/>{} aggregate, {} whole and {} cut</figcaption>\n</figure>\n",
      output::image(picture, name, ""), escape(name), output::percent(d.fraction), d.sample.whole(),
      d.sample.cut);
}

std::string legend() {
  using specimen::phase_colour;
  namespace phase = specimen::phase;
  return "<p class=\"legend\">\n" + output::swatch(phase_colour(phase::aggregate), "aggregate") +
         output::swatch(phase_colour(phase::mortar), "mortar") +
         output::swatch(phase_colour(phase::itz), "ITZ") +
         output::swatch(phase_colour(phase::void_), "void") + "</p>\n";
}

std::string pictures(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  std::string html = legend() + "<div class=\"pictures\">\n" +
                     figure(specimen::preview(task.original.mask), "The original", task.descriptors);
  for (const TwinRecord& twin : twins)
    if (!twin.picture.empty())
      html += figure(twin.picture, fmt::format("Twin of seed {}", twin.seed), twin.descriptors);
  return html + "</div>\n";
}

std::string figures_table(const TwinTask& task, const specimen::Misfit& misfit) {
  std::vector<std::vector<std::string>> rows;
  for (const FigureRow& row : figure_rows(task, misfit))
    rows.push_back({row.name, row.original, row.mean, row.deviation, row.range, row.difference});
  return output::number_table(
      {"Figure", "Original", "Twins, mean", "Standard deviation", "Twins, range", "Off by"}, rows);
}

std::string curves_table(const specimen::Misfit& misfit) {
  std::vector<std::vector<std::string>> rows;
  for (const CurveRow& row : curve_rows(misfit))
    rows.push_back({row.name, row.original, row.mean, row.largest, row.verdict});
  return output::number_table({"Difference from the mean of the (other) twins", "Original", "A twin, mean",
                               "Farthest twin", "The original is"},
                              rows);
}

std::string notes_list(const std::vector<std::string>& notes) {
  std::string html = "<ul class=\"notes\">\n";
  for (const std::string& note : notes) html += "<li>" + escape(output::capitalised(note)) + ".</li>\n";
  return html + "</ul>\n";
}

constexpr const char* s2_caption =
    "Probability that both ends of a segment lie in aggregate, in the mean over all directions.";
constexpr const char* s2_axes_caption =
    "The same along x and along y; they part where aggregates have a direction.";
constexpr const char* size_caption = "Area of aggregates up to a diameter, the circle of the same area.";
constexpr const char* aspect_caption = "Of the ellipses of the same area and second moments.";
constexpr const char* gap_caption =
    "From the outline of each aggregate to the nearest outline of another one.";
constexpr const char* direction_caption = "Counter-clockwise from the horizontal.";
constexpr const char* figure_words =
    "Fraction, sizes, aspect ratios and, where there are any, directions are drawn from the original; places "
    "are "
    "random.";
constexpr const char* curve_words =
    "Differences of S2 are in per cent of fraction (1 - fraction). An original that is not farther off than "
    "the "
    "farthest twin may be one of them, as far as that curve tells.";

}  // namespace

std::string twin_html(const TwinTask& task, const std::vector<TwinRecord>& twins,
                      const specimen::Misfit& misfit, const std::vector<std::string>& notes) {
  using output::chart_figure;
  using output::side_by_side;
  const std::string title = "Twins of " + task.name;
  return output::page(
      title,
      output::heading(title, twins_text(task, twins.size())) +
          section("The original and its twins", pictures(task, twins)) +
          section("How well they match", output::paragraph(figure_words) + figures_table(task, misfit) +
                                             output::paragraph(curve_words) + curves_table(misfit)) +
          section("Where aggregate is",
                  side_by_side("even", chart_figure(s2_chart(task, twins), 500, 330, s2_caption),
                               chart_figure(s2_along_axes_chart(task, twins), 500, 330, s2_axes_caption))) +
          section("Sizes and shapes",
                  side_by_side("even", chart_figure(size_chart(task, twins), 500, 330, size_caption),
                               chart_figure(aspect_chart(task, twins), 500, 330, aspect_caption)) +
                      side_by_side("even",
                                   chart_figure(direction_chart(task, twins), 500, 330, direction_caption),
                                   chart_figure(gap_chart(task, twins), 500, 330, gap_caption))) +
          section("How it was made", notes_list(notes)));
}

}  // namespace app
