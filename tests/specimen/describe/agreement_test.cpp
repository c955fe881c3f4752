#include "specimen/describe/agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "specimen/body/error.hpp"

namespace agreement_test {

using specimen::Agreement;
using specimen::Segmented;

/// Squares of aggregate in mortar: row, column and edge of each.
Segmented squares(int rows, int cols, const std::vector<std::array<int, 3>>& all) {
  Segmented segmented;
  segmented.mask.labels = {rows, cols, specimen::phase::mortar};
  segmented.instances = {rows, cols, 0};
  std::int32_t id = 0;
  for (const auto& [row, col, edge] : all) {
    ++id;
    for (int r = row; r < row + edge; ++r)
      for (int c = col; c < col + edge; ++c) {
        segmented.mask.labels(r, c) = specimen::phase::aggregate;
        segmented.instances(r, c) = id;
      }
  }
  return segmented;
}

constexpr std::size_t aggregate = specimen::phase::aggregate, mortar = specimen::phase::mortar;

TEST(Agreement, SameIsOne) {
  const Segmented one = squares(40, 40, {{3, 3, 10}, {20, 20, 12}});
  const Agreement agreement = specimen::agreement_of(one, one);
  EXPECT_EQ(agreement.phases[aggregate].intersection_over_union, 1);
  EXPECT_EQ(agreement.phases[aggregate].boundary, 1);
  EXPECT_TRUE(std::isnan(agreement.phases[specimen::phase::void_].intersection_over_union));
  EXPECT_TRUE(std::isnan(agreement.phases[specimen::phase::void_].boundary));
  EXPECT_EQ(agreement.matched, 2);
  EXPECT_EQ(agreement.panoptic_quality, 1);
}

TEST(Agreement, ShiftWithinTheToleranceCostsAreaButNoBoundary) {
  const Agreement agreement =
      specimen::agreement_of(squares(40, 40, {{10, 12, 10}}), squares(40, 40, {{10, 10, 10}}));
  EXPECT_NEAR(agreement.phases[aggregate].intersection_over_union, 80.0 / 120, 1e-12);
  EXPECT_EQ(agreement.phases[aggregate].boundary, 1);
  EXPECT_EQ(agreement.phases[mortar].boundary, 1);
  EXPECT_NEAR(agreement.panoptic_quality, 80.0 / 120, 1e-12);
}

TEST(Agreement, BoundariesFarFromAnyOtherCount) {
  // The found one is missing: no boundary at all agrees.
  EXPECT_EQ(
      specimen::agreement_of(squares(40, 40, {}), squares(40, 40, {{10, 10, 10}})).phases[aggregate].boundary,
      0);
  // One of two squares of the same boundary is found: precision 1, recall 1/2.
  const Agreement half =
      specimen::agreement_of(squares(60, 60, {{5, 5, 10}}), squares(60, 60, {{5, 5, 10}, {40, 40, 10}}));
  EXPECT_NEAR(half.phases[aggregate].boundary, 2 * 0.5 / 1.5, 1e-12);
}

TEST(Agreement, AggregatesAreMatchedMissedAndExtra) {
  const Agreement agreement =
      specimen::agreement_of(squares(60, 60, {{5, 5, 10}, {40, 5, 4}, {5, 40, 10}}),
                             squares(60, 60, {{5, 5, 10}, {40, 40, 10}, {5, 45, 10}}));
  EXPECT_EQ(agreement.matched, 1);  // the third pair shares a third of its union
  EXPECT_EQ(agreement.missed, 2);
  EXPECT_EQ(agreement.extra, 2);
  EXPECT_NEAR(agreement.panoptic_quality, 1.0 / 3, 1e-12);
  EXPECT_TRUE(std::isnan(specimen::agreement_of(squares(9, 9, {}), squares(9, 9, {})).panoptic_quality));
}

TEST(Agreement, OtherShapesAreRefused) {
  EXPECT_THROW((void)specimen::agreement_of(squares(9, 9, {}), squares(9, 8, {})), specimen::Error);
}

}  // namespace agreement_test
