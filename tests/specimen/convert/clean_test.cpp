#include "specimen/convert/clean.hpp"

#include <gtest/gtest.h>

#include "tests/specimen/drawn.hpp"

namespace clean_test {

using specimen::Cell;
using specimen::Changed;
using specimen::LeastArea;
using specimen::Raster;
using specimen_test::cells_of;
using specimen_test::draw_disc;
using specimen_test::text_of;
using Rows = std::vector<std::string>;

constexpr auto void_ = specimen::phase::void_;
constexpr auto aggregate = specimen::phase::aggregate;
constexpr auto mortar = specimen::phase::mortar;

LeastArea all(double area) {
  LeastArea least{};
  least.fill(area);
  return least;
}

TEST(Clean, OpeningTakesASpurAndKeepsTheDisc) {
  Raster<Cell> disc(60, 80, mortar);
  draw_disc(disc, 30, 30, 20, Cell{aggregate});
  Raster<Cell> cells = disc;
  for (int c = 30; c < 75; ++c)
    for (int r = 29; r < 32; ++r) cells(r, c) = aggregate;
  const Changed changed = specimen::open_phase(cells, aggregate, 4);
  int differ = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) differ += cells.data[i] != disc.data[i];
  EXPECT_LE(differ, 12);  // the root of the spur may stay rounded
  EXPECT_GT(changed.pixels, 65);
}

TEST(Clean, OpeningGivesAStripToItsNearestNeighbour) {
  // A strip of void between aggregate and mortar, as the mixed colour of a rim makes it.
  auto cells = cells_of({"11 ....", "11 ....", "11 ....", "11 ...."});
  EXPECT_EQ(specimen::open_phase(cells, void_, 1).pixels, 4);
  EXPECT_EQ(text_of(cells), (Rows{"111....", "111....", "111....", "111...."}));
}

TEST(Clean, OpeningAtTheBorderSeesNothingBeyondIt) {
  auto cells = cells_of({"aaa...", "aaa...", "aaa..."});
  const auto before = cells;
  (void)specimen::open_phase(cells, aggregate, 1);
  EXPECT_EQ(text_of(cells), text_of(before));
}

TEST(Clean, ClosingFillsAGapWithTheNearestGrain) {
  auto cells = cells_of({"1111.2222", "1111.2222", "1111.2222", "1111.2222"});
  EXPECT_EQ(specimen::close_aggregates(cells, 1).pixels, 4);
  for (const Cell cell : cells.data) EXPECT_TRUE(cell == specimen::grain(1) || cell == specimen::grain(2));
}

TEST(Clean, IslandsJoinWhatTheyShareTheLongestBoundaryWith) {
  auto cells = cells_of({".....11111",  //
                         ".a...  111",  //
                         ".....11111"});
  const Changed changed = specimen::drop_islands(cells, all(3));
  EXPECT_EQ(changed.pieces, 2);
  EXPECT_EQ(changed.pixels, 3);
  EXPECT_EQ(text_of(cells)[1], ".....11111");  // of the void's edges five lie on the grain, one on mortar
}

TEST(Clean, IslandsInsideIslandsFollow) {
  auto cells = cells_of({".......",  //
                         ".aaaaa.",  //
                         ".a   a.",  //
                         ".a . a.",  //
                         ".a   a.",  //
                         ".aaaaa.",  //
                         "......."});
  const Changed changed = specimen::drop_islands(cells, all(20));
  EXPECT_EQ(changed.pieces, 3);
  for (const Cell cell : cells.data) EXPECT_EQ(cell, mortar);
}

TEST(Clean, LeastAreaIsPerPhaseAndExact) {
  LeastArea least{};
  least[aggregate] = 2;
  auto cells = cells_of({"a.aa. ."});
  EXPECT_EQ(specimen::drop_islands(cells, least).pieces, 1);
  EXPECT_EQ(text_of(cells), (Rows{"..aa. ."}));
}

TEST(Clean, SpecksAloneStayAsTheyAre) {
  auto cells = cells_of({"a.a.", ".a.a"});
  EXPECT_EQ(specimen::drop_islands(cells, all(5)).pieces, 0);
  EXPECT_EQ(text_of(cells), (Rows{"a.a.", ".a.a"}));
}

TEST(Clean, AbsorbTakesVoidsInsideAggregateButNotThoseInMortar) {
  auto cells = cells_of({"aaaaaaaa........",  //
                         "aaa  aaa...  ...",  //
                         "aaaaaaaa........",  //
                         "aaaaaaaa........"});
  const Changed changed = specimen::absorb(cells, void_, aggregate, 0.6);
  EXPECT_EQ(changed.pieces, 1);
  EXPECT_EQ(changed.pixels, 2);
  EXPECT_EQ(text_of(cells)[1], "aaaaaaaa...  ...");
}

TEST(Clean, AbsorbNeedsAHostFourTimesAsLarge) {
  auto cells = cells_of({"aaaa", "a  a", "a  a", "aaaa"});  // 12 pixels round 4
  EXPECT_EQ(specimen::absorb(cells, void_, aggregate, 0.6).pieces, 0);
}

TEST(Clean, HolesOfOneGrainAreFilledAndPocketsBetweenGrainsAreNot) {
  auto cells = cells_of({"1111222..",  //
                         "1.11.22.3",  //
                         "11112.2..",  //
                         "1111222.."});
  const Changed changed = specimen::fill_holes(cells);
  EXPECT_EQ(changed.pieces, 1);
  EXPECT_EQ(text_of(cells)[1][1], '1');
  EXPECT_EQ(text_of(cells)[1][4], '.');  // between 1 and 2, and it touches the hole of 2 at a corner
}

TEST(Clean, ABayThatReachesTheBorderIsNoHole) {
  auto cells = cells_of({"a.a", "a.a", "aaa"});
  EXPECT_EQ(specimen::fill_holes(cells).pieces, 0);
}

TEST(Clean, LargestAggregateIsThatOfTheLargestPiece) {
  EXPECT_EQ(specimen::largest_aggregate(cells_of({"aa.112", "aa.112"})), 4);
  EXPECT_EQ(specimen::largest_aggregate(cells_of({"..", ".."})), 0);
}

}  // namespace clean_test
