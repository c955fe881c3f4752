/// The building blocks of the report page: HTML, its style, its scripts. Arguments named `html` are HTML
/// already, all others are plain text and escaped.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "specimen/picture/picture.hpp"

namespace output {

/// A line of a table of figures.
struct Fact {
  std::string name;
  std::string value;
  std::string unit = {};  ///< empty: the value is text
};

/// A whole page that needs no network and no script.
[[nodiscard]] std::string page(const std::string& title, const std::string& html);

/// A whole page that needs no network, with the script of reports and what it reads. The page runs this
/// script and no other, whatever else may stand in it.
/// @param data  JSON without any of < > &.
[[nodiscard]] std::string live_page(const std::string& title, const std::string& html,
                                    const std::string& data);

/// The same, which asks the server that it came from, and no other, how the run goes on.
[[nodiscard]] std::string watching_page(const std::string& title, const std::string& html,
                                        const std::string& data);

/// A page that fills the window, with the script by which strokes are drawn over a picture. It asks the
/// server that it came from, and no other.
[[nodiscard]] std::string editing_page(const std::string& title, const std::string& html,
                                       const std::string& data);

/// A piece of a page that a script may replace.
[[nodiscard]] std::string part(const std::string& id, const std::string& html);

/// Title of the page and a line below it.
[[nodiscard]] std::string heading(const std::string& title, const std::string& setting);
[[nodiscard]] std::string section(const std::string& heading, const std::string& html);
[[nodiscard]] std::string paragraph(const std::string& text);

/// A section that stands by itself: what `make` returns, or where that throws, a section of this heading that
/// tells the fault, so that the rest of the page is not lost with it.
[[nodiscard]] std::string standing(const std::string& heading, const std::function<std::string()>& make);
[[nodiscard]] std::string remarks(const std::string& html);   ///< small, below what they are about
[[nodiscard]] std::string pictures(const std::string& html);  ///< figures beside each other
[[nodiscard]] std::string notes_list(const std::vector<std::string>& notes);

/// A section of what speaks against a specimen, see specimen::doubts_of(); empty where there is nothing.
[[nodiscard]] std::string warnings_section(const std::vector<std::string>& doubts);

/// Two columns on wide screens, one on narrow ones.
/// @param css_class  "even", "lead" (the left one is wider) or "fit" (the left one is as wide as its
/// content).
[[nodiscard]] std::string side_by_side(const std::string& css_class, const std::string& left_html,
                                       const std::string& right_html);

/// Two beside each other, again and again.
[[nodiscard]] std::string in_pairs(const std::vector<std::string>& htmls);

/// Names, values and units in three columns.
[[nodiscard]] std::string facts_table(const std::vector<Fact>& facts);

/// A table that scrolls where it is too wide.
/// @param css_class  "numbers", or "claims" for sentences.   @param rows_html  each with its <tr>.
[[nodiscard]] std::string table(const std::string& css_class, const std::vector<std::string>& head,
                                const std::string& rows_html);

/// A table whose first column holds names and whose others hold numbers.
[[nodiscard]] std::string number_table(const std::vector<std::string>& head,
                                       const std::vector<std::vector<std::string>>& rows);

/// A chart, laid out twice: for wide screens at a width and height [px], and for phones.
/// @param id  by which the script of a live page finds it, to draw in its place; empty = it does not.
[[nodiscard]] std::string chart_figure(const std::string& id, const Chart& chart, double width, double height,
                                       const std::string& caption);
[[nodiscard]] std::string chart_figure(const Chart& chart, double width, double height,
                                       const std::string& caption);

/// Where the script of a live page may draw a chart for which there is nothing yet.
[[nodiscard]] std::string chart_place(const std::string& id, const std::string& caption);

/// An embedded picture, shown at a whole number of screen pixels per picture pixel where it is small enough.
[[nodiscard]] std::string image(const specimen::Raster<specimen::Rgb>& picture,
                                const std::string& alternative, const std::string& css_class);

/// A small square of colour with a name.
[[nodiscard]] std::string swatch(specimen::Rgb colour, const std::string& name);

/// What the colours of a picture mean.
/// @param css_class  beside "legend"; may be empty.
[[nodiscard]] std::string legend(const std::string& css_class, const std::vector<LegendEntry>& entries);

/// Text in a fixed-width face that is folded away at first.
[[nodiscard]] std::string folded(const std::string& heading, const std::string& text);

/// Style sheet: light and dark by the reader's setting, phones, print.
[[nodiscard]] std::string report_style();

[[nodiscard]] std::string_view page_style();         ///< CSS of the page, but for its inks
[[nodiscard]] std::string_view glossary_page();      ///< docs/glossary.md
[[nodiscard]] std::string_view chart_style();        ///< CSS of uPlot
[[nodiscard]] std::string_view chart_library();      ///< uPlot: defines uPlot
[[nodiscard]] std::string_view animation_library();  ///< gifenc, a CommonJS module: fills `exports`
[[nodiscard]] std::string_view report_script();      ///< ours, which needs both
[[nodiscard]] std::string_view watching_script();    ///< follows it on the page of a run that goes on
[[nodiscard]] std::string_view editing_style();      ///< CSS of the page on which strokes are drawn
[[nodiscard]] std::string_view editing_script();     ///< all that it does

}  // namespace output
