#include "specimen/body/mask.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"

namespace specimen {
namespace mask_test {

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
                 "phase: one more; at most 256 phases can be told apart; give several phases one name");
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

}  // namespace mask_test
}  // namespace specimen
