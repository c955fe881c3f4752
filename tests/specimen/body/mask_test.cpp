#include "specimen/body/mask.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "specimen/body/error.hpp"

namespace specimen {
namespace mask_test {

using specimen::Components;
using specimen::connected_pieces;
using specimen::Connectivity;
using specimen::Raster;
using testing::ElementsAre;

LabelledMask two_by_three() { return {{2, 3, phase::mortar}, 0.5, standard_phases()}; }

TEST(Mask, RowNoughtIsOnTopAndYPointsUp) {
  const LabelledMask mask = two_by_three();
  EXPECT_EQ(mask.centre(0, 0), (Point{0.25, 0.75}));
  EXPECT_EQ(mask.centre(1, 0), (Point{0.25, 0.25}));  // bottom left: half a pixel inside both edges
  EXPECT_EQ(mask.centre(1, 2), (Point{1.25, 0.25}));
  EXPECT_EQ(mask.width(), 1.5);
  EXPECT_EQ(mask.height(), 1.0);
}

TEST(Mask, StandardPhasesStandAtTheirLabels) {
  const std::vector<std::string> names = standard_phases();
  ASSERT_EQ(names.size(), 4u);
  EXPECT_EQ(names[phase::void_], "void");
  EXPECT_EQ(names[phase::aggregate], "aggregate");
  EXPECT_EQ(names[phase::mortar], "mortar");
  EXPECT_EQ(names[phase::itz], "itz");
}

TEST(Mask, LabelOfFindsOrAddsAName) {
  std::vector<std::string> phases = standard_phases();
  EXPECT_EQ(label_of(phases, "mortar"), phase::mortar);
  EXPECT_EQ(phases.size(), 4u);
  EXPECT_EQ(label_of(phases, "fibre"), 4);
  EXPECT_EQ(label_of(phases, "fibre"), 4);
  EXPECT_THAT(phases, ElementsAre("void", "aggregate", "mortar", "itz", "fibre"));
}

TEST(Mask, LabelOfRefusesAnEmptyNameAndA257thPhase) {
  std::vector<std::string> phases = standard_phases();
  EXPECT_THROW((void)label_of(phases, ""), Error);
  for (int n = 4; n < 256; ++n) EXPECT_EQ(label_of(phases, "phase " + std::to_string(n)), n);
  try {
    (void)label_of(phases, "one more");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "phase: one more; at most 256 phases are allowed; give several phases the same name");
  }
  EXPECT_EQ(label_of(phases, "phase 255"), 255);
}

TEST(Mask, CountsEveryLabel) {
  LabelledMask mask = two_by_three();
  mask.labels(0, 1) = phase::aggregate;
  mask.labels(1, 2) = phase::itz;
  EXPECT_THAT(count_labels(mask), ElementsAre(0, 1, 4, 1));
}

TEST(Mask, RefusesALabelWithoutAName) {
  LabelledMask mask = two_by_three();
  mask.labels(0, 1) = 9;
  try {
    (void)count_labels(mask);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "mask: label 9; has no name: there are 4 phases");
  }
}

Raster<std::uint8_t> raster(int cols, std::vector<std::uint8_t> values) {
  Raster<std::uint8_t> r(static_cast<int>(values.size()) / cols, cols);
  r.data = std::move(values);
  return r;
}

TEST(Components, CornersJoinOnlyWhereAsked) {
  const auto picture = raster(2, {1, 0,  //
                                  0, 1});
  EXPECT_EQ(connected_pieces(picture, Connectivity::edges).count(), 4);
  EXPECT_EQ(connected_pieces(picture, Connectivity::corners).count(), 2);
}

TEST(Components, NumbersPiecesInReadingOrderAndCountsThem) {
  const auto picture = raster(5, {7, 7, 3, 7, 7,  //
                                  7, 3, 3, 3, 7,  //
                                  7, 7, 7, 7, 7});
  const Components pieces = connected_pieces(picture, Connectivity::edges);
  EXPECT_EQ(pieces.area, (std::vector<std::int64_t>{11, 4}));
  EXPECT_EQ(pieces.piece(0, 0), 0);
  EXPECT_EQ(pieces.piece(0, 4), 0);  // joined from below, though met apart
  EXPECT_EQ(pieces.piece(1, 2), 1);
}

TEST(Components, FollowsASpiralAsOnePiece) {
  const int n = 41;
  Raster<std::int32_t> spiral(n, n, 0);
  int r = 0, c = 0, dr = 0, dc = 1;
  const auto free = [&](int row, int col) { return spiral.contains(row, col) && spiral(row, col) == 0; };
  for (int turns = 0; turns < 2;) {
    spiral(r, c) = 1;
    // Two ahead must be free too, so that a gap stays between the arms.
    if (free(r + dr, c + dc) && (!spiral.contains(r + 2 * dr, c + 2 * dc) || free(r + 2 * dr, c + 2 * dc))) {
      r += dr, c += dc, turns = 0;
    } else {
      std::swap(dr, dc);
      dc = -dc;
      ++turns;
    }
  }
  const Components pieces = connected_pieces(spiral, Connectivity::edges);
  EXPECT_EQ(pieces.count(), 2);
  EXPECT_EQ(std::accumulate(pieces.area.begin(), pieces.area.end(), std::int64_t{0}), n * n);
}

}  // namespace mask_test
}  // namespace specimen
