#include "specimen/convert/grains.hpp"

#include <gtest/gtest.h>

#include "tests/specimen/drawn.hpp"

namespace grains_test {

using specimen_test::cells_of;
using specimen_test::text_of;
using Rows = std::vector<std::string>;
using specimen::Cell;
using specimen::Raster;
using specimen_test::draw_disc;

TEST(Grains, NumbersPiecesInReadingOrderAndKeepsTouchingValuesApart) {
  auto cells = cells_of({"..a.a", "a..a.", "77.88", "77888"});
  EXPECT_EQ(specimen::number_grains(cells), 6);
  EXPECT_EQ(text_of(cells), (Rows{"..1.2", "3..4.", "55.66", "55666"}));
  EXPECT_EQ(specimen::grain_numbers(cells), (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6}));
}

int grains_after_split(const Raster<Cell>& drawn, double depth) {
  auto cells = drawn;
  specimen::number_grains(cells);
  const int count = specimen::split_grains(cells, depth);
  for (std::size_t i = 0; i < cells.size(); ++i)
    EXPECT_EQ(specimen::phase_of(cells.data[i]), specimen::phase_of(drawn.data[i]));
  return count;
}

Raster<Cell> two_discs(double distance, double radius = 20) {
  Raster<Cell> cells(60, 120, specimen::phase::mortar);
  draw_disc(cells, 30, 60 - distance / 2, radius, Cell{specimen::phase::aggregate});
  draw_disc(cells, 30, 60 + distance / 2, radius, Cell{specimen::phase::aggregate});
  return cells;
}

TEST(Split, CutsTwoDiscsAtTheirNeck) {
  Raster<Cell> cells = two_discs(32);  // the neck is 2 * 12 wide: 40 % less than the discs
  specimen::number_grains(cells);
  ASSERT_EQ(specimen::split_grains(cells, 0.2), 2);
  EXPECT_NE(cells(30, 44), cells(30, 76));
  int left = 0, right = 0;
  for (const Cell cell : cells.data) {
    left += cell == cells(30, 44);
    right += cell == cells(30, 76);
  }
  EXPECT_NEAR(left, right, 40);  // a column or so of pixels
}

TEST(Split, DepthSaysHowDeepANeckMustBe) {
  // At this distance the neck reaches sqrt(20^2 - 12^2) = 16 of 20: 20 % deep.
  EXPECT_EQ(grains_after_split(two_discs(24), 0.1), 2);
  EXPECT_EQ(grains_after_split(two_discs(24), 0.3), 1);
}

TEST(Split, LeavesRoughAndLongGrainsWhole) {
  Raster<Cell> cells(60, 120, specimen::phase::mortar);
  for (int c = 10; c < 110; ++c)
    for (int r = 20 + c % 3; r < 40 - c % 2; ++r) cells(r, c) = specimen::phase::aggregate;
  EXPECT_EQ(grains_after_split(cells, 0.2), 1);
}

TEST(Split, LeavesASquareThatTheBorderCutsWhole) {
  Raster<Cell> cells(40, 40, specimen::phase::mortar);
  draw_disc(cells, 0, 20, 18, Cell{specimen::phase::aggregate});
  EXPECT_EQ(grains_after_split(cells, 0.2), 1);
}

TEST(Split, KeepsGrainsApartThatWereApartBefore) {
  Raster<Cell> cells(30, 60, specimen::grain(1));
  for (int r = 0; r < 30; ++r)
    for (int c = 30; c < 60; ++c) cells(r, c) = specimen::grain(2);
  EXPECT_EQ(specimen::split_grains(cells, 0.2), 2);
  EXPECT_NE(cells(15, 29), cells(15, 30));
}

TEST(Cut, PartsAGrainAndLeavesNoPixelOut) {
  Raster<Cell> cells = two_discs(20);
  Raster<std::uint8_t> cut(60, 120, 0);
  for (int r = 0; r < 60; ++r) cut(r, 59) = cut(r, 60) = 1;
  const Raster<Cell> drawn = cells;
  specimen::number_grains(cells);
  EXPECT_EQ(specimen::cut_grains(cells, cut), 2);
  EXPECT_EQ(cells(30, 59), cells(30, 44));
  EXPECT_EQ(cells(30, 60), cells(30, 76));
  for (std::size_t i = 0; i < cells.size(); ++i)
    EXPECT_EQ(specimen::phase_of(cells.data[i]), specimen::phase_of(drawn.data[i]));
}

TEST(Cut, StrokeThatCoversAGrainLeavesItWhole) {
  Raster<Cell> cells = two_discs(60, 10);
  Raster<std::uint8_t> cut(60, 120, 0);
  for (int r = 0; r < 60; ++r)
    for (int c = 0; c < 60; ++c) cut(r, c) = 1;
  specimen::number_grains(cells);
  EXPECT_EQ(specimen::cut_grains(cells, cut), 2);
}

TEST(Join, MakesOneOfTheGrainsThatAMarkCrosses) {
  Raster<Cell> cells(10, 50, specimen::phase::mortar);
  for (int c = 0; c < 50; ++c)
    for (int r = 2; r < 8; ++r)
      if (c % 10 < 8) cells(r, c) = specimen::phase::aggregate;  // five of them, two pixels apart
  ASSERT_EQ(specimen::number_grains(cells), 5);
  Raster<std::uint8_t> marks(10, 50, 0);
  for (int c = 4; c < 16; ++c) marks(5, c) = 1;
  for (int c = 34; c < 45; ++c) marks(c < 40 ? 3 : 4, c) = 1;
  EXPECT_EQ(specimen::join_grains(cells, marks), 3);
  EXPECT_EQ(cells(5, 4), cells(2, 17));
  EXPECT_EQ(cells(5, 34), cells(5, 44));
  EXPECT_NE(cells(5, 4), cells(5, 24));
  EXPECT_NE(cells(5, 24), cells(5, 34));
  EXPECT_EQ(cells(5, 8), Cell{specimen::phase::mortar}) << "what lies between them stays";
}

TEST(Join, MarksThatMeetAreOne) {
  Raster<Cell> cells(3, 30, specimen::phase::mortar);
  for (const int c : {2, 12, 22}) cells(1, c) = specimen::phase::aggregate;
  specimen::number_grains(cells);
  Raster<std::uint8_t> marks(3, 30, 0);
  for (int c = 2; c < 8; ++c) marks(0, c) = marks(1, c) = 1;
  for (int c = 8; c < 23; ++c) marks(c < 12 ? 2 : 1, c) = 1;  // begins at a corner of the first
  EXPECT_EQ(specimen::join_grains(cells, marks), 1);
}

}  // namespace grains_test
