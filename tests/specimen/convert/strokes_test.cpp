#include "specimen/convert/strokes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"

namespace strokes_test {

using specimen::cut_stroke;
using specimen::Error;
using specimen::no_stroke;
using specimen::Picture;
using specimen::Rgb;
using specimen::StrokeLine;
using ::testing::HasSubstr;

Picture layer(int rows, int cols) {
  Picture picture;
  picture.colour = specimen::Raster<Rgb>(rows, cols);
  picture.opacity = specimen::Raster<std::uint8_t>(rows, cols, 0);
  return picture;
}

void paint(Picture& picture, int row, int col, Rgb colour, std::uint8_t opacity = 255) {
  picture.colour(row, col) = colour;
  picture.opacity(row, col) = opacity;
}

template <class Call>
std::string complaint_of(Call call) {
  try {
    (void)call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(PaintedStrokes, ColoursOfThePhasesShowThem) {
  Picture picture = layer(4, 5);
  paint(picture, 0, 0, {255, 255, 255});
  paint(picture, 1, 1, {112, 128, 150});
  paint(picture, 2, 2, {220, 200, 165});  // nearly that of mortar
  paint(picture, 3, 3, {0, 0, 0});
  paint(picture, 0, 4, {112, 128, 150}, 120);  // the fading rim of a brush
  const auto strokes = specimen::painted_strokes(picture, "s.png", {});
  EXPECT_EQ(strokes.labels(0, 0), specimen::phase::void_);
  EXPECT_EQ(strokes.labels(1, 1), specimen::phase::aggregate);
  EXPECT_EQ(strokes.labels(2, 2), specimen::phase::mortar);
  EXPECT_EQ(strokes.labels(3, 3), cut_stroke);
  EXPECT_EQ(strokes.labels(0, 4), no_stroke);
  EXPECT_EQ(strokes.labels(1, 0), no_stroke);
  EXPECT_TRUE(strokes.joins.empty());
}

TEST(PaintedStrokes, MagentaMakesOneGrain) {
  Picture picture = layer(3, 3);
  paint(picture, 0, 0, {112, 128, 150});
  paint(picture, 1, 2, {255, 0, 255});
  const auto strokes = specimen::painted_strokes(picture, "s.png", {});
  EXPECT_EQ(strokes.labels(1, 2), no_stroke);
  EXPECT_EQ(strokes.joins(1, 2), 1);
  EXPECT_EQ(strokes.joins(0, 0), 0);
}

TEST(PaintedStrokes, NamedPhasesHaveTheColoursOfTheirLabels) {
  Picture picture = layer(2, 2);
  paint(picture, 0, 0, specimen::phase_colour(5));
  const auto strokes = specimen::painted_strokes(picture, "s.png", {{5, "fibre"}});
  EXPECT_EQ(strokes.labels(0, 0), 5);
  EXPECT_EQ(strokes.phases, (std::vector<std::string>{"void", "aggregate", "mortar", "itz", "", "fibre"}));
  EXPECT_EQ(
      complaint_of([&] {
        return specimen::painted_strokes(picture, "s.png", {{1, "fibre"}});
      }),
      "convert.label_phases: 1:fibre; the colour of label 1 is that of aggregate; give phases of your own a "
      "label above 3");
}

TEST(PaintedStrokes, OtherColoursAreRefusedWithThoseThatThereAre) {
  Picture picture = layer(10, 10);
  for (int c = 0; c < 10; ++c) paint(picture, 0, c, {255, 0, 0}), paint(picture, 1, c, {112, 128, 150});
  const std::string complaint = complaint_of([&] { return specimen::painted_strokes(picture, "s.png", {}); });
  EXPECT_THAT(
      complaint,
      HasSubstr("s.png: 10 pixels of a colour that is no phase's, most of them #ff0000 at 10 pixels"));
  EXPECT_THAT(complaint, HasSubstr("aggregate #708096"));
  EXPECT_THAT(complaint, HasSubstr("a cut between two aggregates #000000, one grain of several #ff00ff"));
}

TEST(PaintedStrokes, OpaqueAndEmptyLayersAreRefused) {
  Picture opaque = layer(3, 3);
  opaque.opacity = {};
  EXPECT_THAT(
      complaint_of([&] { return specimen::painted_strokes(opaque, "s.png", {}); }),
      HasSubstr("s.png: is opaque everywhere; strokes must be transparent where nothing is painted; paint on "
                "a new layer"));
  opaque.opacity = specimen::Raster<std::uint8_t>(3, 3, 255);
  EXPECT_THAT(complaint_of([&] { return specimen::painted_strokes(opaque, "s.png", {}); }),
              HasSubstr("opaque everywhere"));
  EXPECT_THAT(complaint_of([&] { return specimen::painted_strokes(layer(3, 3), "s.png", {}); }),
              HasSubstr("s.png: has no strokes"));
}

TEST(StrokesAlong, LineCoversWhatLiesWithinHalfItsWidth) {
  const auto strokes = specimen::strokes_along({{"mortar", 3, {{2, 5.5}, {8, 5.5}}, "s.csv:2"}}, 10, 12);
  for (int r = 0; r < 10; ++r)
    for (int c = 0; c < 12; ++c) {
      const double x = c + 0.5, dx = x < 2 ? 2 - x : x > 8 ? x - 8 : 0, dy = r - 5.0;
      EXPECT_EQ(strokes.labels(r, c) == specimen::phase::mortar, dx * dx + dy * dy <= 1.5 * 1.5)
          << r << " " << c;
    }
}

TEST(StrokesAlong, NewNamesAreNewPhasesAndCutIsNone) {
  const auto strokes =
      specimen::strokes_along({{"fibre", 1, {{1.5, 1.5}}, "a"}, {"cut", 1, {{5.5, 1.5}}, "b"}}, 4, 8);
  EXPECT_EQ(strokes.phases.back(), "fibre");
  EXPECT_EQ(strokes.labels(1, 1), 4);
  EXPECT_EQ(strokes.labels(1, 5), cut_stroke);
}

TEST(StrokesAlong, LaterLineLiesOverEarlierOnes) {
  const std::vector<StrokeLine> crossing{{"mortar", 1, {{0, 4.5}, {9, 4.5}}, "s.csv:2"},
                                         {"aggregate", 1, {{4.5, 0}, {4.5, 9}}, "s.csv:7"},
                                         {"cut", 1, {{0, 4.5}, {1, 4.5}}, "s.csv:9"}};
  const auto strokes = specimen::strokes_along(crossing, 9, 9);
  EXPECT_EQ(strokes.labels(4, 4), specimen::phase::aggregate);
  EXPECT_EQ(strokes.labels(4, 5), specimen::phase::mortar);
  EXPECT_EQ(strokes.labels(4, 0), cut_stroke);
  EXPECT_EQ(strokes.painted_over, 3);
}

TEST(StrokesAlong, OneGrainLiesBesideAllOthers) {
  const auto strokes = specimen::strokes_along(
      {{"mortar", 1, {{0, 4.5}, {9, 4.5}}, "a"}, {"one-grain", 1, {{4.5, 0}, {4.5, 9}}, "b"}}, 9, 9);
  EXPECT_EQ(strokes.labels(4, 4), specimen::phase::mortar);
  EXPECT_EQ(strokes.labels(0, 4), no_stroke);
  for (int r = 0; r < 9; ++r)
    for (int c = 0; c < 9; ++c) EXPECT_EQ(strokes.joins(r, c), c == 4 ? 1 : 0) << r << " " << c;
  EXPECT_EQ(strokes.phases, specimen::standard_phases());
  EXPECT_EQ(strokes.painted_over, 0);
}

TEST(StrokesAlong, MistakesAreRefusedWithTheirPlace) {
  EXPECT_EQ(complaint_of([&] {
              return specimen::strokes_along({{"mortar", 1, {{3, 20}}, "s.csv:2"}}, 9, 9);
            }),
            "s.csv:2: a point at x = 3, y = 20 px; must lie on the picture of 9 x 9 px; x counts pixels from "
            "the left "
            "and y from the top");
  EXPECT_EQ(complaint_of([&] {
              return specimen::strokes_along({{"mortar", 0, {{3, 2}}, "s.csv:2"}}, 9, 9);
            }),
            "s.csv:2: a width of 0 px; must be 1 to 1000 px");
  EXPECT_EQ(complaint_of([&] {
              return specimen::strokes_along({{"mortar", 1, {}, "s.csv:2"}}, 9, 9);
            }),
            "s.csv:2: no points; a stroke needs one at least");
}

}  // namespace strokes_test
