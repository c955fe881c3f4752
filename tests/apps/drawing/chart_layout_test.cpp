#include "apps/drawing/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace chart_layout_test {

using namespace output;

Chart two_lines() {
  return {"a chart",
          {"Strain", "microstrain"},
          {"Stress", "MPa"},
          {{"rising", {0, 100, 200}, {0, 2, 3}, Ink::first, false},
           {"level", {0, 200}, {1, 1}, Ink::second, true}},
          {{200, 3, "peak 3.00 MPa at 200 microstrain"}}};
}

template <class T>
std::vector<T> all(const Drawing& drawing) {
  std::vector<T> found;
  for (const Shape& shape : drawing.shapes)
    if (const T* item = std::get_if<T>(&shape)) found.push_back(*item);
  return found;
}

std::vector<std::string> words_of(const Drawing& drawing) {
  std::vector<std::string> texts;
  for (const Words& words : all<Words>(drawing)) texts.push_back(words.text);
  return texts;
}

bool has(const Drawing& drawing, const std::string& text) {
  const auto texts = words_of(drawing);
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

/// Lines of data in an ink that are more than a sample of the legend.
Stroke data_line(const Drawing& drawing, Ink ink) {
  std::vector<Stroke> strokes = all<Stroke>(drawing);
  std::erase_if(strokes, [&](const Stroke& s) { return s.ink != ink; });
  EXPECT_FALSE(strokes.empty());
  return strokes.back();
}

TEST(ChartLayout, NamesAxesWithUnitsAndSeriesInALegend) {
  const Drawing drawing = lay_out(two_lines(), 600, 400);
  for (const char* text : {"Strain (microstrain)", "Stress (MPa)", "rising", "level"})
    EXPECT_TRUE(has(drawing, text)) << text;
  EXPECT_EQ(drawing.title, "a chart");
}

TEST(ChartLayout, NeedsNoLegendForOneLine) {
  Chart chart = two_lines();
  chart.series.pop_back();
  EXPECT_FALSE(has(lay_out(chart, 600, 400), "rising"));
}

TEST(ChartLayout, LeavesALineWithoutANameOutOfTheLegend) {
  Chart chart = two_lines();
  const auto strokes = all<Stroke>(lay_out(chart, 600, 400)).size();
  chart.series.back().name.clear();
  EXPECT_EQ(all<Stroke>(lay_out(chart, 600, 400)).size(), strokes - 1);  // the line, but not its sample
  chart.series.front().name.clear();
  EXPECT_EQ(all<Stroke>(lay_out(chart, 600, 400)).size(), strokes - 2);
}

TEST(ChartLayout, PutsLargerValuesHigherAndFartherRight) {
  const Stroke line = data_line(lay_out(two_lines(), 600, 400), Ink::first);
  ASSERT_EQ(line.places.size(), 3U);
  EXPECT_LT(line.places[0].x, line.places[1].x);
  EXPECT_GT(line.places[0].y, line.places[1].y);  // y points down
  EXPECT_NEAR(line.places[2].x - line.places[1].x, line.places[1].x - line.places[0].x, 1e-9);
  EXPECT_NEAR((line.places[0].y - line.places[1].y) / 2, line.places[1].y - line.places[2].y, 1e-9);
}

TEST(ChartLayout, PutsTheMarkerOnItsPoint) {
  const Drawing drawing = lay_out(two_lines(), 600, 400);
  const Dot dot = all<Dot>(drawing).at(0);
  const Place end = data_line(drawing, Ink::first).places.back();
  EXPECT_DOUBLE_EQ(dot.centre.x, end.x);
  EXPECT_DOUBLE_EQ(dot.centre.y, end.y);
}

TEST(ChartLayout, TurnsTheWordsOfAMarkerInwardsAtTheEdge) {
  Chart chart = two_lines();
  EXPECT_EQ(all<Words>(lay_out(chart, 600, 400)).back().anchor, Anchor::end);
  chart.markers[0].x = 20;
  EXPECT_EQ(all<Words>(lay_out(chart, 600, 400)).back().anchor, Anchor::start);
}

/// In DejaVu Sans, the widest of the usual sans-serif faces: figures of 0.636, letters of about 0.55 of the
/// size.
double length_of(const Words& words) {
  double length = 0;
  for (const char c : words.text)
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) length += c >= '0' && c <= '9' ? 0.636 : 0.55;
  return length * words.size;
}

TEST(ChartLayout, KeepsEverythingOnThePaper) {
  for (const double width : {350.0, 480.0, 720.0})
    for (const double scale : {1e-6, 1.0, 1e5}) {
      Chart chart = two_lines();
      for (double& value : chart.series[0].y) value *= scale;
      chart.markers.clear();
      const Drawing drawing = lay_out(chart, width, 300);
      for (const Words& words : all<Words>(drawing)) {
        const double length = length_of(words);
        const double left = words.at.x - (words.anchor == Anchor::start    ? 0
                                          : words.anchor == Anchor::middle ? 0.5
                                                                           : 1) *
                                             length;
        EXPECT_GE(left, 0) << words.text;
        EXPECT_LE(left + length, width) << words.text;
        EXPECT_GE(words.at.y - words.size, 0) << words.text;
        EXPECT_LE(words.at.y + 0.25 * words.size, 300) << words.text;
      }
      for (const Stroke& stroke : all<Stroke>(drawing))
        for (const Place& place : stroke.places) {
          EXPECT_TRUE(place.x >= 0 && place.x <= width && place.y >= 0 && place.y <= 300);
        }
    }
}

TEST(ChartLayout, DrawsAnEmptyChart) {
  const Drawing drawing =
      lay_out({"empty", {"x", ""}, {"y", ""}, {{"none", {}, {}, Ink::first, false}}, {}}, 400, 300);
  for (const Stroke& stroke : all<Stroke>(drawing))
    for (const Place& place : stroke.places) EXPECT_TRUE(std::isfinite(place.x) && std::isfinite(place.y));
}

TEST(ChartLayout, DrawsNegativeValuesBelowZero) {
  Chart chart = two_lines();
  chart.series[0].y = {0, -1, 3};
  const Stroke line = data_line(lay_out(chart, 600, 400), Ink::first);
  EXPECT_GT(line.places[1].y, line.places[0].y);
}

TEST(ChartLayout, LeavesZeroOutOfATightAxis) {
  Chart chart{"far from zero", {"x", ""}, {"y", ""}, {{"line", {50, 51}, {100, 102}}}, {}};
  const auto height = [&] {
    const Stroke line = data_line(lay_out(chart, 600, 400), Ink::first);
    return line.places.front().y - line.places.back().y;
  };
  EXPECT_LT(height(), 10);
  chart.y.tight = true;
  EXPECT_GT(height(), 250);
  chart.x.tight = true;
  const Stroke line = data_line(lay_out(chart, 600, 400), Ink::first);
  EXPECT_GT(line.places.back().x - line.places.front().x, 400);
}

TEST(ChartLayout, DrawsNoMarkerWithoutAPlace) {
  Chart chart = two_lines();
  chart.markers[0].x = std::nan("");
  EXPECT_TRUE(all<Dot>(lay_out(chart, 600, 400)).empty());
}

/// Errors that fall tenfold while the time grows tenfold, over five decades.
Chart logarithmic_chart() {
  Chart chart = two_lines();
  chart.x = {"Time", "s", true};
  chart.y = {"Error", "", true};
  chart.series = {{"GIMP", {0.01, 0.1, 1}, {1, 0.1, 1e-5}, Ink::first, false, true}};
  chart.markers.clear();
  return chart;
}

TEST(ChartLayout, PutsEqualRatiosAtEqualDistancesOnLogarithmicAxes) {
  const Stroke line = data_line(lay_out(logarithmic_chart(), 600, 400), Ink::first);
  ASSERT_EQ(line.places.size(), 3U);
  EXPECT_NEAR(line.places[2].x - line.places[1].x, line.places[1].x - line.places[0].x, 1e-9);
  EXPECT_NEAR((line.places[2].y - line.places[1].y) / (line.places[1].y - line.places[0].y), 4, 1e-9);
  EXPECT_TRUE(has(lay_out(logarithmic_chart(), 600, 400), "10⁻⁵"));
  EXPECT_TRUE(has(lay_out(logarithmic_chart(), 600, 400), "0.01"));
}

TEST(ChartLayout, HasWordsOfAnotherSizeAndNoLegendWhereItIsUnwanted) {
  Chart chart = logarithmic_chart();
  chart.series.push_back(chart.series[0]);
  chart.series[0].name = "one";
  chart.series[1].name = "two";
  const Drawing small = lay_out(chart, 300, 200, 0.5), usual = lay_out(chart, 600, 400);
  EXPECT_DOUBLE_EQ(all<Words>(usual).front().size, 13);
  EXPECT_DOUBLE_EQ(all<Words>(small).front().size, 6.5);
  EXPECT_TRUE(has(usual, "two"));
  chart.has_legend = false;
  EXPECT_FALSE(has(lay_out(chart, 600, 400), "two"));
}

TEST(ChartLayout, LeavesWhatHasNoLogarithmOut) {
  Chart chart = logarithmic_chart();
  chart.series[0].y[2] = 0;
  EXPECT_EQ(data_line(lay_out(chart, 600, 400), Ink::first).places.size(), 2U);
  EXPECT_EQ(all<Dot>(lay_out(chart, 600, 400)).size(), 2U);
  chart.series[0].y = {0, -1, 0};
  EXPECT_TRUE(all<Dot>(lay_out(chart, 600, 400)).empty());
}

TEST(ChartLayout, DrawsDotsWhereTheyAreAskedForAndMarkersWithoutWords) {
  Chart chart = logarithmic_chart();
  EXPECT_EQ(all<Dot>(lay_out(chart, 600, 400)).size(), 3U);
  const auto words = words_of(lay_out(chart, 600, 400));
  chart.markers = {{0.1, 0.1, ""}};
  EXPECT_EQ(words_of(lay_out(chart, 600, 400)), words);
  const std::vector<Dot> dots = all<Dot>(lay_out(chart, 600, 400));
  ASSERT_EQ(dots.size(), 4U);
  EXPECT_DOUBLE_EQ(dots[3].centre.x, dots[1].centre.x);
  chart.series[0].dotted = false;
  EXPECT_EQ(all<Dot>(lay_out(chart, 600, 400)).size(), 1U);
}

}  // namespace chart_layout_test
